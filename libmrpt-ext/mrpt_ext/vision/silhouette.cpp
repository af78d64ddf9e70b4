#include "mrpt_ext/vision/silhouette.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/quantile.h"
#include "mrpt_ext/vision/light_coding.h"
#include "mrpt_ext/vision/outline_fit.h"

namespace mrpt_ext
{
namespace
{
double envd(const char*n,double d){const char*s=getenv(n);return s?atof(s):d;}
constexpr double kReach = 7;          ///< [px] beyond an object's edges that is looked at
constexpr double kOutlier = 3;        ///< standard deviations
constexpr double kAgreement = 0.15;   ///< [px] by which slices may differ in any case, as standard deviation
constexpr int kRounds = 6;
constexpr double kUsualBlur = 1.0, kStdBlur = 1.0;  ///< [px]
constexpr double kStdRatio = 0.1;     ///< of the seen width over the expected one
constexpr double kMostBlur = 3, kLeastBlur = 0.4;
constexpr double kMostOff = 4;        ///< [px] from the guess
constexpr int kCorrelated = 8;        ///< slices, beyond which residuals of JPEG's blocks are independent

/// What the slices of an object have in common.
struct Common
{
  double offset = 0;  ///< [rad] from the guess
  double ratio = 1;   ///< of its width to the expected one
  double blur = kUsualBlur;
};

struct Located
{
  Common common;
  double std_offset = 0, std_ratio = 0;
  int slices = 0;
};

using Equations = OutlineEquations (*)(const SliceProfile&, const Outline&);

/// One slice at the present outline.
struct SliceState
{
  OutlineEquations equations;  ///< by offset [rad], ratio and blur
  double variance = 1;
  Eigen::Vector2d step{0, 0};  ///< what the slice alone would add to offset and ratio
  bool used = true;
};

SliceState stateOf(const SliceProfile& profile, const Common& common, Equations equations)
{
  SliceState state;
  const double sl = profile.shift_low, sh = profile.shift_high;
  state.equations = equations(
      profile, {common.offset / profile.per_pixel + (sl - sh) / 2, common.ratio * profile.half_width - (sl + sh) / 2,
                common.blur});
  const Eigen::Vector3d scale(1 / profile.per_pixel, profile.half_width, 1);
  state.equations.information = scale.asDiagonal() * state.equations.information * scale.asDiagonal();
  state.equations.gradient = scale.asDiagonal() * state.equations.gradient;
  state.variance = state.equations.meanSquare();
  Eigen::Matrix2d own = state.equations.information.topLeftCorner<2, 2>();
  own.diagonal() *= 1.001;
  own.diagonal().array() += 1e-9;
  state.step = own.inverse() * state.equations.gradient.head<2>();
  return state;
}

/// Keeps the slices whose `value` is near the median of all.
template <typename Value>
void dropOutliers(std::vector<SliceState>& slices, double floor, const Value& value)
{
  std::vector<double> values;
  for (const SliceState& s : slices) if(s.used) values.push_back(value(s));
  if (values.empty()) return;
  const double centre = upperMedian(values);
  for (double& v : values) v = std::abs(v - centre);
  const double limit = kOutlier * std::max(1.4826 * upperMedian(values), floor);
  for (SliceState& s : slices)
    if (std::abs(value(s) - centre) > limit) s.used = false;
}

/// Mean correlation of the residuals of two slices.
double meanCorrelation(const std::vector<const SliceState*>& slices)
{
  const auto count = slices.size();
  double squares = 0;
  for (const SliceState* s : slices) squares += s->variance;
  squares /= static_cast<double>(count);
  double sum = 0;
  for (std::size_t lag = 1; lag <= std::min<std::size_t>(kCorrelated, count - 1); ++lag)
  {
    double product = 0; std::size_t terms = 0;
    for (std::size_t i = lag; i < count; ++i)
    {
      const auto &a = slices[i - lag]->equations.residuals, &b = slices[i]->equations.residuals;
      const auto n = std::min(a.size(), b.size())/2;  // aligned at the middle
      // profiles of different length: compare around the middle
      const std::size_t ca = a.size()/2, cb = b.size()/2; (void)n;
      const std::size_t half = std::min(ca, cb);
      for (std::size_t k = 0; k < 2*half; ++k) { product += a[ca-half+k]*b[cb-half+k]; ++terms; }
    }
    const double correlation = product / std::max<double>(1, static_cast<double>(terms)) / squares;
    if (correlation < 0.05) break;
    sum += 2 * correlation * static_cast<double>(count - lag);
  }
  return sum / static_cast<double>(count * (count - 1));
}

std::optional<Located> locate(const std::vector<SliceProfile>& profiles, Common common, Equations equations,
                              int min_slices)
{
  std::vector<SliceState> slices;
  Eigen::Matrix3d information;
  double noise=1;
  double per_pixel = 0;
  for (const SliceProfile& profile : profiles) per_pixel += profile.per_pixel / static_cast<double>(profiles.size());
  for (int round = 0; round <= kRounds; ++round)
  {
    slices.clear();
    std::vector<double> variances;
    for (const SliceProfile& profile : profiles)
    {
      slices.push_back(stateOf(profile, common, equations));
      variances.push_back(slices.back().variance);
    }
    noise = std::max(upperMedian(variances), 1e-3);
    if (round > 1)
    {
      dropOutliers(slices, kAgreement/ profiles.front().half_width, [](const SliceState& s) { return s.step[1]; });
      dropOutliers(slices, kAgreement * per_pixel, [](const SliceState& s) { return s.step[0]; });
    }
    information = Eigen::Vector3d(1e-6, 1 / square(kStdRatio), 1 / square(kStdBlur)).asDiagonal();
    Eigen::Vector3d gradient(0, (1 - common.ratio) / square(kStdRatio), (kUsualBlur - common.blur) / square(kStdBlur));
    for (const SliceState& s : slices)
      if (s.used)
      {
        const double weight = 1 / std::max(noise, s.variance);
        information += weight * s.equations.information, gradient += weight * s.equations.gradient;
      }
    if (round == kRounds) break;
    const Eigen::Vector3d step = information.inverse() * gradient;
    common.offset += std::clamp(step[0], -per_pixel, per_pixel);
    common.ratio = std::clamp(common.ratio + std::clamp(step[1], -0.2, 0.2), 0.3, 2.0);
    common.blur = std::clamp(common.blur + step[2], kLeastBlur, kMostBlur);
    if (!(std::abs(common.offset) < kMostOff * per_pixel)) return std::nullopt;
  }
  std::vector<const SliceState*> used;
  for (const SliceState& s : slices)
    if (s.used) used.push_back(&s);
  const auto count = static_cast<double>(used.size());
  if (static_cast<int>(used.size()) < min_slices || used.size() < 2) return std::nullopt;
  const Eigen::Matrix3d inverse = information.inverse();
  Eigen::Vector3d scatter = Eigen::Vector3d::Zero();
  for (const SliceState* s : used)
  {
    const Eigen::Vector3d influence = inverse * s->equations.gradient / std::max(noise, s->variance);
    scatter += influence.cwiseAbs2();
  }
  const double prior = envd("NU",4);
  const double kx = envd("KX",1.5);
  const Eigen::Vector3d expected = kx*inverse.diagonal();
  const double r = std::min(envd("RMAX",0.8), meanCorrelation(used));
  const double inflation = (1 + (count - 1) * r) / (1 - r);
  Eigen::Vector3d variance = (count / (count - 1) * scatter * (count - 1) + prior * expected) / (count - 1 + prior);
  if(getenv("DBG")) fprintf(stderr,"off %.3f px ratio %.3f blur %.2f n %g/%zu r %.2f infl %.2f scatter %.3f expected %.3f noise %.2f\n",common.offset/per_pixel,common.ratio,common.blur,count,slices.size(),r,inflation,std::sqrt(scatter[0])/per_pixel,std::sqrt(expected[0])/per_pixel,std::sqrt(noise));
  variance *= inflation;
  return Located{common, std::sqrt(variance[0]), std::sqrt(variance[1]), static_cast<int>(used.size())};
}
}  // namespace

std::optional<Silhouette> measureSilhouette(const cv::Mat& image, const HyperbolicMirror& mirror, double azimuth,
                                            const std::vector<SilhouetteSlice>& slices, int min_slices,
                                            bool by_brightness)
{
  std::vector<SliceProfile> profiles;
  for (const SilhouetteSlice& slice : slices)
    if (auto profile = profileOf(image, mirror, azimuth, slice, kReach)) profiles.push_back(std::move(*profile));
  if (static_cast<int>(profiles.size()) < min_slices) return std::nullopt;
  if (envd("CODING",1)>0) for (auto& p : profiles) {
    const double h = p.half_width, in = std::max(h-1.5,0.4*h);
    const auto sh=[&](double a,double b){ const double x=p.lumaAt(a), y=p.lumaAt(b); return (y>x?1:-1)*shiftByCoding(std::max(1.,x),std::max(1.,y)); };
    p.shift_low=sh(-in,-h-1.5); p.shift_high=sh(in,h+1.5);
  }
  auto located = locate(profiles, {}, colourEquations, min_slices);
  if (!located) return std::nullopt;
  if (by_brightness && envd("BRIGHT",1)>0)
    if (const auto bright = locate(profiles, {located->common.offset, located->common.ratio, kUsualBlur}, brightnessEquations, min_slices))
    {
      const double off = bright->common.offset - located->common.offset;
      const double vc = square(located->std_offset), vb = square(bright->std_offset);
      if (square(off) < 9 * (vc + vb))
      {
        located->common.offset += off * vc / (vb + vc);
        located->std_offset = std::sqrt(vb * vc / (vb + vc));
        const double rc = square(located->std_ratio), rb = square(bright->std_ratio);
        located->common.ratio += (bright->common.ratio - located->common.ratio) * rc / (rb + rc);
        located->std_ratio = std::sqrt(rb * rc / (rb + rc));
      }
    }
  return Silhouette{wrap(azimuth + located->common.offset), located->std_offset, located->common.ratio,
                    located->std_ratio, located->slices};
}
}  // namespace mrpt_ext
