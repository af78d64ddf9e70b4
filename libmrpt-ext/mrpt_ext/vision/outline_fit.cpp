#include "mrpt_ext/vision/outline_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr double kClearOfEdge = 1.5;     ///< [px] from an edge, where samples are no mixtures
constexpr double kMostClearShare = 0.6;  ///< of the half width
constexpr double kLevelRidge = 1e-6;     ///< grey levels that do not show stay zero

/// Density and distribution function of the standard normal distribution.
struct Normal
{
  double density = 0, below = 0;
};

/// By linear interpolation in a table, to 1e-4.
class NormalTable
{
 public:
  NormalTable()
  {
    for (std::size_t i = 0; i < values_.size(); ++i)
    {
      const double z = kLowest + static_cast<double>(i) * kStep;
      values_[i] = {std::exp(-0.5 * z * z) / std::sqrt(kTwoPi), 0.5 * std::erfc(-z / std::sqrt(2.0))};
    }
  }
  [[nodiscard]] Normal at(double z) const
  {
    const double place = std::clamp((z - kLowest) / kStep, 0.0, static_cast<double>(values_.size()) - 1.001);
    const auto i = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(i);
    const auto between = [share](double a, double b) { return a + share * (b - a); };
    return {between(values_[i].density, values_[i + 1].density), between(values_[i].below, values_[i + 1].below)};
  }

 private:
  static constexpr double kLowest = -5, kStep = 1.0 / 32;
  std::array<Normal, 321> values_{};
};

Normal normalFromTable(double z)
{
  static const NormalTable table;
  return table.at(z);
}

/// Integrals of 1, t and t^2 from -h to h over a Gaussian around u, and their derivatives by u, h and the Gaussian's
/// standard deviation.
struct BlurredPowers
{
  std::array<double, 3> value{}, by_position{}, by_half_width{}, by_blur{};
  Normal low, high;  ///< at either end
};

BlurredPowers blurredPowers(double u, double h, double s)
{
  const double p = (u + h) / s, q = (u - h) / s;
  BlurredPowers b;
  const Normal low = b.low = normalFromTable(p), high = b.high = normalFromTable(q);
  const double difference = low.density - high.density, sum = low.density + high.density;
  const double moments = p * low.density - q * high.density, other = p * low.density + q * high.density;
  b.value[0] = low.below - high.below;
  b.value[1] = u * b.value[0] + s * difference;
  b.value[2] = (u * u + s * s) * b.value[0] + 2 * u * s * difference - s * s * moments;
  b.by_position = {difference / s, b.value[0] - h * sum / s, 2 * b.value[1] + h * h * difference / s};
  b.by_half_width = {sum / s, -h * difference / s, h * h * sum / s};
  b.by_blur = {-moments / s, difference + h * other / s, 2 * s * b.by_position[1] - h * h * moments / s};
  return b;
}

/// Least squares with `Unknowns` linear ones, of each channel its own, that are eliminated, for the first `Parameters`
/// of the outline. All channels have the same rows.
template <int Unknowns, int Channels, int Parameters>
class Eliminated
{
 public:
  using Row = Eigen::Matrix<double, 1, Unknowns>;
  using Derivatives = Eigen::Matrix<double, Unknowns, Parameters>;  ///< of a row's entries by the outline
  using Values = Eigen::Matrix<double, 1, Channels>;

  explicit Eliminated(std::size_t count) { samples_.reserve(count); }
  void add(const Row& row, const Derivatives& derivatives, const Values& values)
  {
    samples_.push_back({row, derivatives, values});
    normal_ += row.transpose() * row, right_ += row.transpose() * values;
  }
  [[nodiscard]] OutlineEquations equations() const
  {
    OutlineEquations equations;
    auto information = equations.information.template topLeftCorner<Parameters, Parameters>();
    auto gradient = equations.gradient.template head<Parameters>();
    const Eigen::LDLT<Normal> solver(normal_);
    for (int c = 0; c < Channels; ++c)
    {
      const Eigen::Matrix<double, Unknowns, 1> solution = solver.solve(right_.col(c));
      Derivatives mixed = Derivatives::Zero();
      std::vector<double>& residuals = equations.residuals.emplace_back();
      residuals.reserve(samples_.size());
      for (const Sample& s : samples_)
      {
        const Eigen::Matrix<double, 1, Parameters> slope = solution.transpose() * s.derivatives;
        const double residual = s.values[c] - s.row.dot(solution);
        mixed += s.row.transpose() * slope, information += slope.transpose() * slope;
        gradient += slope.transpose() * residual;
        residuals.push_back(residual);
        equations.slopes += slope[0] * slope[0], equations.slope_squares += square(slope[0] * residual);
      }
      for (int i = 0; i < Parameters; ++i)
      {
        const Eigen::Matrix<double, Unknowns, 1> column = solver.solve(mixed.col(i));
        information.col(i) -= mixed.transpose() * column;
      }
    }
    return equations;
  }

 private:
  using Normal = Eigen::Matrix<double, Unknowns, Unknowns>;
  struct Sample
  {
    Row row;
    Derivatives derivatives;
    Values values;
  };
  std::vector<Sample, Eigen::aligned_allocator<Sample>> samples_;
  Normal normal_ = kLevelRidge * Normal::Identity();
  Eigen::Matrix<double, Unknowns, Channels> right_ = decltype(right_)::Zero();
};
}  // namespace

double OutlineEquations::meanSquare() const
{
  double sum = 0, count = 0;
  for (const auto& channel : residuals)
    for (const double residual : channel) sum += residual * residual, ++count;
  return count > 0 ? sum / count : 0;
}

namespace
{
/// Shares of the object and of what is on either side of it in a sample, and their derivatives by the outline.
struct Shares
{
  double object = 0, left = 0, right = 0;
  Eigen::RowVector3d object_slope, left_slope, right_slope;
};

Shares sharesAt(double u, const Outline& outline)
{
  const double s = outline.blur, low = (u + outline.half_width) / s, high = (u - outline.half_width) / s;
  const Normal at_low = normalFromTable(low), at_high = normalFromTable(high);
  Shares shares;
  shares.left = 1 - at_low.below, shares.right = at_high.below, shares.object = at_low.below - at_high.below;
  shares.left_slope = at_low.density / s * Eigen::RowVector3d(1, -1, low);
  shares.right_slope = at_high.density / s * Eigen::RowVector3d(-1, -1, -high);
  shares.object_slope = -shares.left_slope - shares.right_slope;
  return shares;
}

/// Colour with one background, or with one on either side.
template <int Backgrounds>
OutlineEquations colourEquationsWith(const SliceProfile& profile, const Outline& outline)
{
  using Unknowns = Eliminated<1 + Backgrounds, 2, 3>;
  const double h = outline.half_width, clear = std::min(kClearOfEdge * outline.blur, kMostClearShare * h);
  Unknowns channels(profile.size());
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    const double u = profile.first + static_cast<double>(i) - outline.offset;
    const Shares shares = sharesAt(u, outline);
    const double of_object = profile.lumaAt(outline.offset + std::clamp(u, clear - h, h - clear));
    const double of_background =
        std::abs(u) < h + clear ? profile.lumaAt(outline.offset + std::copysign(h + clear, u)) : profile.luma[i];
    typename Unknowns::Row row;
    typename Unknowns::Derivatives derivatives;
    row[0] = shares.object * of_object;
    derivatives.row(0) = of_object * shares.object_slope;
    if constexpr (Backgrounds == 1)
    {
      row[1] = (shares.left + shares.right) * of_background;
      derivatives.row(1) = of_background * (shares.left_slope + shares.right_slope);
    }
    else
    {
      row[1] = shares.left * of_background, row[2] = shares.right * of_background;
      derivatives.row(1) = of_background * shares.left_slope;
      derivatives.row(2) = of_background * shares.right_slope;
    }
    channels.add(row, derivatives, {profile.chroma[0][i], profile.chroma[1][i]});
  }
  return channels.equations();
}
}  // namespace

OutlineEquations colourEquations(const SliceProfile& profile, const Outline& outline)
{
  return colourEquationsWith<1>(profile, outline);
}

OutlineEquations colourEquationsOfSides(const SliceProfile& profile, const Outline& outline)
{
  return colourEquationsWith<2>(profile, outline);
}

OutlineEquations brightnessEquations(const SliceProfile& profile, const Outline& outline)
{
  const double h = profile.half_width;  // what the shade's terms are counted in
  using Unknowns = Eliminated<3, 1, kOutlineParameters>;
  Unknowns luma(profile.size());
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    const double u = profile.first + static_cast<double>(i) - outline.offset;
    const BlurredPowers b = blurredPowers(u, outline.half_width, outline.blur);
    const auto shaded = [&](const std::array<double, 3>& v)
    { return v[0] + outline.tilt * v[1] / h - outline.bulge * v[2] / (h * h); };
    const double s = outline.blur, low = b.low.density / s, high = b.high.density / s;
    const Unknowns::Row row(1 - b.low.below, b.high.below, shaded(b.value));
    Unknowns::Derivatives derivatives;
    derivatives.row(0) << low, -low, low * (u + outline.half_width) / s, 0, 0;
    derivatives.row(1) << -high, -high, -high * (u - outline.half_width) / s, 0, 0;
    derivatives.row(2) << -shaded(b.by_position), shaded(b.by_half_width), shaded(b.by_blur), b.value[1] / h,
        -b.value[2] / (h * h);
    luma.add(row, derivatives, Unknowns::Values(profile.luma[i]));
  }
  return luma.equations();
}
}  // namespace mrpt_ext
