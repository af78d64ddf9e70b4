#include "mrpt_ext/vision/silhouette.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/vision/outline_fit.h"

namespace mrpt_ext
{
namespace
{
constexpr double kReach = 7;                       ///< [px] beyond an object's edges that is looked at
constexpr int kNewtonRounds = 6;                   ///< of Gauss and Newton
constexpr double kLastStep = 0.005;                ///< [px] of the edges, which is no longer worth a round
constexpr int kAllAgree = 2;                       ///< the first rounds, in which no slice is left out
constexpr double kOutlierSlice = 3;                ///< standard deviations
constexpr double kAgreement = 0.15;                ///< [px] by which slices may differ in any case, as std. deviation
constexpr double kUsualBlur = 1, kStdBlur = 1;     ///< [px]
constexpr double kLeastBlur = 0.4, kMostBlur = 3;  ///< [px]
constexpr double kUsualBulge = 0.3, kStdShade = 0.5;  ///< of tilt and bulge, where nothing shows
constexpr double kMostShade = 1;
constexpr double kStdRatio = 0.1;        ///< of the seen width over the expected one, where nothing shows
constexpr double kStdRatioOfPart = 0.3;  ///< likewise of a part that is seen
constexpr double kLeastRatio = 0.3, kMostRatio = 2;
constexpr double kMostRatioStep = 0.2;
constexpr double kProfileKnown = 0.035;    ///< of the blur, to which an edge is known that is not as soft as a Gaussian
constexpr double kBlurKnown = 0.2;         ///< of the fitted blur, by which one may differ that is no Gaussian
constexpr double kMostOff = 4;             ///< [px] from the guess
constexpr double kLeastSliceNoise = 0.03;  ///< [grey levels] of a slice's mean
constexpr double kEdgeWidth = 2;           ///< of an edge, over its blur
constexpr double kScatterPrior = 4;        ///< slices that the expected scatter counts for
constexpr std::size_t kMostCorrelatedSlices = 8;  ///< of two pixels: blocks of coarse chroma are 16 pixels high
constexpr double kNoCorrelation = 0.05;           ///< what is less is noise of the estimate
constexpr double kMostCorrelation = 0.8;

using Equations = OutlineEquations (*)(const SliceProfile&, const Outline&);

/// What is looked for.
struct OutlineQuery
{
  Equations colour = colourEquations;
  int side = 0;                  ///< whose edge is located: -1 or 1; 0: the middle
  double std_ratio = kStdRatio;  ///< of the width, where nothing shows
};

/// What the slices of an object have in common.
struct Common
{
  double offset = 0;  ///< [rad] of the middle, or of the edge that is looked for, from the guess
  double ratio = 1;   ///< of its width to the expected one
  double blur = kUsualBlur;
  double tilt = 0, bulge = kUsualBulge;  ///< of its shade
};

/// The same with standard deviations.
struct Located
{
  Common common;
  double std_offset = 0, std_ratio = 0;
  int slices = 0;  ///< that agree
};

/// One slice at the present outline; equations are by offset [rad], ratio, blur and shade.
struct Slice
{
  OutlineEquations equations;
  double variance = 1;         ///< of its residuals
  Eigen::Vector2d step{0, 0};  ///< what it alone would add to offset and ratio
};

Slice sliceAt(const SliceProfile& profile, const Common& common, Equations equations, int side)
{
  Slice slice;
  // An edge that stays where it is takes the middle along when the width changes.
  const double middle = common.offset / profile.per_pixel - side * (common.ratio - 1) * profile.half_width;
  slice.equations =
      equations(profile, {middle + 0.5 * (profile.shift_low - profile.shift_high),
                          common.ratio * profile.half_width - 0.5 * (profile.shift_low + profile.shift_high),
                          common.blur, common.tilt, common.bulge});
  OutlineMatrix outline_by_common = OutlineMatrix::Identity();
  outline_by_common(0, 0) = 1 / profile.per_pixel, outline_by_common(1, 1) = profile.half_width;
  outline_by_common(0, 1) = -side * profile.half_width;
  slice.equations.information = outline_by_common.transpose() * slice.equations.information * outline_by_common;
  slice.equations.gradient = outline_by_common.transpose() * slice.equations.gradient;
  slice.variance = slice.equations.meanSquare();
  Eigen::Matrix2d own = slice.equations.information.topLeftCorner<2, 2>();
  own.diagonal() *= 1 + 1e-3;
  own.diagonal().array() += 1e-9;
  slice.step = own.inverse() * slice.equations.gradient.head<2>();
  return slice;
}

/// Keeps the slices whose `value` is near the median of all.
template <typename Value>
void dropOutliers(std::vector<Slice>& slices, double floor, const Value& value)
{
  std::vector<double> values;
  for (const Slice& s : slices) values.push_back(value(s));
  if (values.empty()) return;
  const double centre = upperMedian(values);
  for (double& v : values) v = std::abs(v - centre);
  const double limit = kOutlierSlice * std::max(upperMedian(values) / kNormalMedianDeviation, floor);
  std::erase_if(slices, [&](const Slice& s) { return std::abs(value(s) - centre) > limit; });
}

using Channels = std::vector<std::vector<double>>;

/// Means of as many neighbours as an edge is wide: what is left of residuals there moves the edge.
Channels meansOver(const Channels& residuals, std::size_t window)
{
  Channels means;
  for (const auto& channel : residuals)
  {
    auto& into = means.emplace_back();
    double sum = 0;
    for (std::size_t i = 0; i < channel.size(); ++i)
    {
      sum += channel[i] - (i >= window ? channel[i - window] : 0);
      if (i + 1 >= window) into.push_back(sum / static_cast<double>(window));
    }
  }
  return means;
}

/// Mean product of values at the same place of both profiles, counted from the middle.
double meanProduct(const Channels& a, const Channels& b)
{
  double sum = 0, count = 0;
  for (std::size_t c = 0; c < a.size(); ++c)
  {
    const std::size_t common = std::min(a[c].size(), b[c].size());
    const double* const first = a[c].data() + (a[c].size() - common) / 2;
    const double* const second = b[c].data() + (b[c].size() - common) / 2;
    sum += std::inner_product(first, first + common, second, 0.0), count += static_cast<double>(common);
  }
  return count > 0 ? sum / count : 0;
}

/// How residuals are correlated, as noise of images and JPEG's blocks are.
struct Correlation
{
  double along = 1;    ///< variance that edges have by it, over that by independent samples
  double between = 0;  ///< mean correlation of two slices
};

Correlation correlationOf(const std::vector<Slice>& slices, double blur)
{
  const auto window = static_cast<std::size_t>(std::max(1.0, std::round(kEdgeWidth * blur)));
  const std::size_t count = slices.size();
  std::vector<Channels> means;
  double variance = 0, squares = 0, products = 0, slopes = 0, at_edges = 0;
  for (const Slice& s : slices)
  {
    means.push_back(meansOver(s.equations.residuals, window));
    variance += s.variance, squares += meanProduct(means.back(), means.back());
    slopes += s.equations.slopes, at_edges += s.equations.slope_squares;
  }
  if (!(squares > 0)) return {};
  for (std::size_t lag = 1; lag <= std::min(kMostCorrelatedSlices, count - 1); ++lag)
  {
    double sum = 0;
    for (std::size_t i = lag; i < count; ++i) sum += meanProduct(means[i - lag], means[i]);
    if (sum < kNoCorrelation * squares) break;
    products += sum;
  }
  const double mean = products / squares * 2 / static_cast<double>(count - 1);
  const double edges = at_edges / slopes / (variance / static_cast<double>(count));
  return {std::max(1.0, squares / variance * static_cast<double>(window)) * std::max(1.0, edges),
          std::min(kMostCorrelation, mean)};
}

/// The outline that the slices have in common, by Gauss and Newton.
class OutlineSearch
{
 public:
  OutlineSearch(const std::vector<SliceProfile>& profiles, Equations equations, const OutlineQuery& search)
      : profiles_(profiles), equations_(equations), search_(search)
  {
    for (const SliceProfile& p : profiles) per_pixel_ += p.per_pixel / static_cast<double>(profiles.size());
  }

  [[nodiscard]] std::optional<Located> from(const Common& start, int min_slices)
  {
    common_ = start;
    for (int round = 0; round < kNewtonRounds; ++round)
    {
      linearise(round >= kAllAgree);
      const bool is_last = move(information_.inverse() * gradient_) && round >= kAllAgree;
      if (!(std::abs(common_.offset) < kMostOff * per_pixel_)) return std::nullopt;
      if (is_last) break;
    }
    linearise(true);
    if (static_cast<int>(slices_.size()) < std::max(2, min_slices)) return std::nullopt;
    return located();
  }

 private:
  void linearise(bool without_outliers)
  {
    slices_.clear();
    std::vector<double> variances;
    for (const SliceProfile& profile : profiles_)
    {
      slices_.push_back(sliceAt(profile, common_, equations_, search_.side));
      variances.push_back(slices_.back().variance);
    }
    noise_ = std::max(upperMedian(variances), kLeastSliceNoise * kLeastSliceNoise);
    if (without_outliers)
    {
      dropOutliers(slices_, kAgreement / profiles_.front().half_width, [](const Slice& s) { return s.step[1]; });
      dropOutliers(slices_, kAgreement * per_pixel_, [](const Slice& s) { return s.step[0]; });
    }
    const OutlineVector information{1e-6, 1 / square(search_.std_ratio), 1 / square(kStdBlur), 1 / square(kStdShade),
                                    1 / square(kStdShade)};
    const OutlineVector off{0, 1 - common_.ratio, kUsualBlur - common_.blur, -common_.tilt,
                            kUsualBulge - common_.bulge};
    information_ = information.asDiagonal();
    gradient_ = information.cwiseProduct(off);
    for (const Slice& s : slices_)
    {
      information_ += weightOf(s) * s.equations.information;
      gradient_ += weightOf(s) * s.equations.gradient;
    }
  }

  /// True when the step was too small for another one.
  bool move(const OutlineVector& step)
  {
    common_.offset += std::clamp(step[0], -per_pixel_, per_pixel_);
    common_.ratio += std::clamp(step[1], -kMostRatioStep, kMostRatioStep);
    common_.ratio = std::clamp(common_.ratio, kLeastRatio, kMostRatio);
    common_.blur = std::clamp(common_.blur + step[2], kLeastBlur, kMostBlur);
    common_.tilt = std::clamp(common_.tilt + step[3], -kMostShade, kMostShade);
    common_.bulge = std::clamp(common_.bulge + step[4], -kMostShade, kMostShade);
    const double edges = std::abs(step[0]) / per_pixel_ + std::abs(step[1]) * profiles_.front().half_width;
    return edges + std::abs(step[2]) < kLastStep;
  }

  /// Slices that do not fit as well as most have noise of their own.
  [[nodiscard]] double weightOf(const Slice& slice) const { return 1 / std::max(noise_, slice.variance); }

  /// Few slices do not show how far they scatter: what is expected by their noise counts as well. Their correlation
  /// makes them scatter less than they are wrong.
  [[nodiscard]] Located located() const
  {
    const auto count = static_cast<double>(slices_.size());
    const OutlineMatrix covariance = information_.inverse();
    OutlineVector scatter = OutlineVector::Zero();
    for (const Slice& s : slices_) scatter += (weightOf(s) * covariance * s.equations.gradient).cwiseAbs2();
    const Correlation correlation = correlationOf(slices_, common_.blur);
    const double left_out = static_cast<double>(profiles_.size()) / count;  // some of it noise like the others'
    const double inflation = left_out * (1 + (count - 1) * correlation.between) / (1 - correlation.between);
    const OutlineVector variance = inflation / (count - 1 + kScatterPrior) *
                                   (count * scatter + kScatterPrior * correlation.along * covariance.diagonal());
    return {common_, std::hypot(std::sqrt(variance[0]), kProfileKnown * common_.blur * per_pixel_),
            std::hypot(std::sqrt(variance[1]), ratioByBlur()), static_cast<int>(slices_.size())};
  }

  /// What an error of the blur does to the width: of a soft object its second moment is seen, h^2 / 3 of the outline
  /// and the square of the blur.
  [[nodiscard]] double ratioByBlur() const
  {
    const double half_width = common_.ratio * profiles_[profiles_.size() / 2].half_width;
    return 3 * kBlurKnown * square(common_.blur / half_width);
  }

  const std::vector<SliceProfile>& profiles_;
  Equations equations_;
  OutlineQuery search_;
  double per_pixel_ = 0;  ///< [rad] mean
  Common common_;
  std::vector<Slice> slices_;  ///< that agree
  double noise_ = 1;           ///< median variance of residuals
  OutlineMatrix information_;
  OutlineVector gradient_;
};

/// Mean of two values weighted by their variances; the deviation of the first becomes that of the mean.
void average(double& value, double& std, double other, double std_other)
{
  const double sum = square(std) + square(std_other);
  value += (other - value) * square(std) / sum;
  std = std * std_other / std::sqrt(sum);
}

/// What brightness tells beside colour, where both agree.
void addBrightness(Located& by_colour, const std::vector<SliceProfile>& profiles, int min_slices,
                   const OutlineQuery& search)
{
  Common start = by_colour.common;
  start.blur = kUsualBlur;
  const auto bright = OutlineSearch(profiles, brightnessEquations, search).from(start, min_slices);
  if (!bright) return;
  Common& common = by_colour.common;
  const double difference =
      std::abs(common.offset - bright->common.offset) / std::hypot(by_colour.std_offset, bright->std_offset);
  if (difference > kOutlierSlice) return;
  average(common.offset, by_colour.std_offset, bright->common.offset, bright->std_offset);
  average(common.ratio, by_colour.std_ratio, bright->common.ratio, bright->std_ratio);
  // A part is few pixels wide: how far both differ tells more than the scatter of its slices (Birge's ratio).
  if (search.side != 0) by_colour.std_offset *= std::max(1.0, difference);
}

std::optional<Located> locate(const cv::Mat& image, const HyperbolicMirror& mirror, double azimuth,
                              const std::vector<SilhouetteSlice>& slices, int min_slices, bool by_brightness,
                              const OutlineQuery& search)
{
  std::vector<SliceProfile> profiles;
  for (const SilhouetteSlice& slice : slices)
    if (auto profile = profileOf(image, mirror, azimuth, slice, kReach)) profiles.push_back(std::move(*profile));
  if (profiles.empty()) return std::nullopt;
  auto located = OutlineSearch(profiles, search.colour, search).from({}, min_slices);
  if (located && by_brightness) addBrightness(*located, profiles, min_slices, search);
  return located;
}
}  // namespace

std::optional<Silhouette> measureSilhouette(const cv::Mat& image, const HyperbolicMirror& mirror, double azimuth,
                                            const std::vector<SilhouetteSlice>& slices, int min_slices,
                                            bool casts_shadow)
{
  const auto located = locate(image, mirror, azimuth, slices, min_slices, !casts_shadow, {});
  if (!located) return std::nullopt;
  return Silhouette{wrap(azimuth + located->common.offset), located->std_offset, located->common.ratio,
                    located->std_ratio, located->slices};
}

std::optional<VisibleEdge> measureEdge(const cv::Mat& image, const HyperbolicMirror& mirror, double azimuth,
                                       const std::vector<SilhouetteSlice>& slices, int min_slices, int side)
{
  const auto located =
      locate(image, mirror, azimuth, slices, min_slices, true, {colourEquationsOfSides, side, kStdRatioOfPart});
  if (!located) return std::nullopt;
  return VisibleEdge{wrap(azimuth + side * slices.front().half_width + located->common.offset), located->std_offset};
}
}  // namespace mrpt_ext
