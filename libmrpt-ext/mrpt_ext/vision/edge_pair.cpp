#include "mrpt_ext/vision/edge_pair.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr int kSamplesPerColumn = 8;
constexpr double kShapeReach = 4;       ///< of an edge's profile, in widths
constexpr double kPeakFoot = 0.15;      ///< share of the peak's height at which it is left
constexpr double kPeakReach = 3.5;      ///< [widths] a peak of two edges is no wider
constexpr double kUnevenWall = 0.01;    ///< standard deviation of the profile beyond noise, share of its height
constexpr double kLeastGain = 30;       ///< of the sum of squared residuals in units of their variance
constexpr double kLeastWeaker = 0.2;    ///< height of the weaker edge, share of the stronger one's
constexpr double kLeastDistance = 0.9;  ///< [widths] between the edges
constexpr double kResolved = 5;         ///< their distance in standard deviations of their places
constexpr double kBetterFit = 4;        ///< of the squares that one soft edge leaves, over those of two edges
constexpr double kWidthUnknown = 0.04;  ///< standard deviation of the width, share
constexpr double kShapeUnknown = 0.18;  ///< [widths] standard deviation of a place, by what else is in the peak
constexpr double kCorrelated = 1.7;     ///< of neighbouring columns: their noise weighs so many times as much
constexpr double kFinestStep = 0.02;    ///< [columns] of the search

using Two = std::array<double, 2>;

/// Columns and values of the peak.
struct Samples
{
  std::vector<double> columns, values;
};

Samples samplesOf(const RunProfile& profile, double column, double reach)
{
  const int middle = static_cast<int>(std::lround(column)), most = static_cast<int>(reach);
  double top = 0;
  for (int k = -1; k <= 1; ++k) top = std::max(top, profile(middle + k));
  int first = middle, last = middle;
  while (middle - first < most && profile(first - 1) > kPeakFoot * top) --first;
  while (last - middle < most && profile(last + 1) > kPeakFoot * top) ++last;
  Samples samples;
  for (int j = first; j <= last; ++j)
  {
    samples.columns.push_back(j);
    samples.values.push_back(profile(j));
  }
  return samples;
}

/// Heights by linear least squares, and the sum of squared residuals.
struct HeightFit
{
  Two height{};
  double squares = 0;
};

HeightFit twoSharp(const Samples& samples, const EdgeShape& shape, const Two& at)
{
  double aa = 0, ab = 0, bb = 0, ay = 0, by = 0, yy = 0;
  for (std::size_t i = 0; i < samples.columns.size(); ++i)
  {
    const double a = shape(samples.columns[i] - at[0]), b = shape(samples.columns[i] - at[1]), y = samples.values[i];
    aa += a * a, ab += a * b, bb += b * b, ay += a * y, by += b * y, yy += y * y;
  }
  const double determinant = aa * bb - ab * ab;
  if (!(determinant > 1e-9 * aa * bb)) return {{0, 0}, yy};
  const Two height{(bb * ay - ab * by) / determinant, (aa * by - ab * ay) / determinant};
  return {height, yy - height[0] * ay - height[1] * by};
}

/// Quantiles of how the light of a soft edge is distributed, with a standard deviation of 1.
using Spread = std::array<double, 7>;
constexpr Spread kEven{-1.485, -0.990, -0.495, 0, 0.495, 0.990, 1.485};
constexpr Spread kNormal{-1.606, -0.867, -0.401, 0, 0.401, 0.867, 1.606};

/// `at`: where, and how soft (standard deviation).
HeightFit oneSoft(const Samples& samples, const EdgeShape& shape, const Two& at, const Spread& spread)
{
  double aa = 0, ay = 0, yy = 0;
  for (std::size_t i = 0; i < samples.columns.size(); ++i)
  {
    double a = 0;
    for (const double quantile : spread) a += shape(samples.columns[i] - at[0] - at[1] * quantile);
    aa += a * a, ay += a * samples.values[i], yy += square(samples.values[i]);
  }
  return {{ay / aa, 0}, yy - ay * ay / aa};
}

/// Descends along both axes and diagonals in steps that are halved.
template <typename Squares>
Two descend(Two best, double step, const Squares& squares)
{
  double least = squares(best);
  while (step > kFinestStep)
  {
    Two next = best;
    for (const double u : {-1.0, 0.0, 1.0})
      for (const double v : {-1.0, 0.0, 1.0})
        if (const Two tried{best[0] + u * step, best[1] + v * step}; squares(tried) < least)
          least = squares(tried), next = tried;
    if (next == best) step /= 2;
    best = next;
  }
  return best;
}

/// Standard deviation of the columns: of the heights' derivatives, what the other three parameters do not explain.
double stdColumn(const Samples& samples, const EdgeShape& shape, const EdgePair& pair, double std_value)
{
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  constexpr double kStep = 0.1;
  for (const double column : samples.columns)
  {
    Eigen::Vector4d row;
    for (int i = 0; i < 2; ++i)
    {
      const double offset = column - pair.column[static_cast<std::size_t>(i)];
      row[i] = shape(offset);
      row[2 + i] =
          pair.height[static_cast<std::size_t>(i)] * (shape(offset - kStep) - shape(offset + kStep)) / (2 * kStep);
    }
    normal += row * row.transpose();
  }
  const Eigen::Matrix4d covariance = normal.inverse();
  const double by_noise = kCorrelated * std_value * std::sqrt(std::max(covariance(2, 2), covariance(3, 3)));
  const double by_width = 2 * kWidthUnknown * square(shape.width()) / (pair.column[1] - pair.column[0]);
  return std::hypot(by_noise, by_width);
}
}  // namespace

EdgeShape::EdgeShape(const std::vector<Row>& rows)
{
  double total = 0, bend = 0, widest = 0;
  for (const Row& row : rows)
  {
    total += row.weight / row.width;  // a wide row is low
    bend += row.weight / (row.width * square(row.width));
    widest = std::max(widest, row.width);
  }
  width_ = std::sqrt(total / bend);
  samples_.resize(static_cast<std::size_t>(kShapeReach * widest * kSamplesPerColumn) + 2, 0.0);
  for (std::size_t i = 0; i + 1 < samples_.size(); ++i)
    for (const Row& row : rows)
      samples_[i] += row.weight / row.width / total *
                     std::exp(-square(static_cast<double>(i) / kSamplesPerColumn / row.width) / 2);
}

double EdgeShape::operator()(double offset) const
{
  const double at = std::abs(offset) * kSamplesPerColumn;
  const auto i = static_cast<std::size_t>(at);
  if (i + 1 >= samples_.size()) return 0;
  const double share = at - static_cast<double>(i);
  return (1 - share) * samples_[i] + share * samples_[i + 1];
}

std::optional<EdgePair> fitEdgePair(const RunProfile& profile, double column, const EdgeShape& shape)
{
  const double width = shape.width();
  const Samples samples = samplesOf(profile, column, kPeakReach * width);
  if (samples.columns.size() < 6) return std::nullopt;
  const double first = samples.columns.front(), last = samples.columns.back();
  const auto pair_squares = [&](const Two& at) { return twoSharp(samples, shape, at).squares; };
  const double middle = (first + last) / 2;
  const Two pair = descend({middle - 0.8 * width, middle + 0.8 * width}, width / 2, pair_squares);
  double soft_squares = pair_squares(pair) * 1e9;
  for (const Spread& spread : {kEven, kNormal})
  {
    const auto squares = [&](const Two& at) { return oneSoft(samples, shape, at, spread).squares; };
    soft_squares = std::min(soft_squares, squares(descend({middle, width}, width / 2, squares)));
  }
  const HeightFit fit = twoSharp(samples, shape, pair);
  EdgePair found{pair, fit.height, 0};
  if (found.column[0] > found.column[1])
  {
    std::swap(found.column[0], found.column[1]);
    std::swap(found.height[0], found.height[1]);
  }
  const double weaker = std::min(fit.height[0], fit.height[1]), stronger = std::max(fit.height[0], fit.height[1]);
  const double variance = square(profile.noise()) + square(kUnevenWall * stronger);
  if (found.column[0] < first || found.column[1] > last || weaker < kLeastWeaker * stronger ||
      found.column[1] - found.column[0] < kLeastDistance * width ||
      soft_squares - fit.squares < kLeastGain * variance || soft_squares < kBetterFit * fit.squares)
    return std::nullopt;
  const double residual = fit.squares / static_cast<double>(samples.columns.size());
  found.std_column = stdColumn(samples, shape, found, std::sqrt(std::max(variance, residual)));
  if (!(found.column[1] - found.column[0] >= kResolved * found.std_column)) return std::nullopt;
  found.std_column = std::hypot(found.std_column, kShapeUnknown * width);
  return found;
}
}  // namespace mrpt_ext
