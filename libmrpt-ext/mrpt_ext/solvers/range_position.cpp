#include "mrpt_ext/solvers/range_position.h"

#include <Eigen/LU>
#include <algorithm>
#include <optional>

#include "mrpt_ext/solvers/levenberg_marquardt.h"
#include "mrpt_ext/solvers/pose_information.h"
#include "mrpt_ext/solvers/two_circles.h"

namespace mrpt_ext
{
namespace
{
constexpr double kRivalChi2 = 9;     // a second minimum this close is a candidate too
constexpr double kSamePlace = 1e-6;  // relative to the extent: two seeds ended in one minimum

bool isUsableRange(const KnownRange& r)
{
  return r.landmark.allFinite() && std::isfinite(r.range) && r.range >= 0 && std::isfinite(r.std) && r.std > 0;
}

NormalEquations<2> modelAt(std::span<const KnownRange> ranges, const Vector2d& position)
{
  NormalEquations<2> result;
  for (const KnownRange& r : ranges)
  {
    const Vector2d d = position - r.landmark;
    const double distance = d.norm();
    const Vector2d row = distance > 0 ? Vector2d(d / (distance * r.std)) : Vector2d(Vector2d::Zero());
    const double e = (distance - r.range) / r.std;
    result.cost += e * e;
    result.gradient += e * row;
    result.hessian += row * row.transpose();
  }
  return result;
}

/// |p - L_i|^2 - r_i^2 minus its weighted mean is linear in p. Nothing for landmarks on one line.
std::optional<Vector2d> linearSeed(std::span<const KnownRange> ranges)
{
  double sum = 0, offset = 0;
  Vector2d mean = Vector2d::Zero();
  for (const KnownRange& r : ranges)
  {
    const double w = 1 / square(r.std * std::max(r.range, r.std));
    sum += w;
    mean += w * r.landmark;
  }
  mean /= sum;
  for (const KnownRange& r : ranges)
  {
    const double w = 1 / square(r.std * std::max(r.range, r.std));
    offset += w / sum * ((r.landmark - mean).squaredNorm() - square(r.range));
  }
  Matrix2d A = Matrix2d::Zero();
  Vector2d v = Vector2d::Zero();
  for (const KnownRange& r : ranges)
  {
    const double w = 1 / square(r.std * std::max(r.range, r.std)) / sum;
    const Vector2d l = r.landmark - mean;
    A += w * l * l.transpose();
    v += w * l * (l.squaredNorm() - square(r.range) - offset) / 2;
  }
  if (!(A.determinant() > 1e-9 * square(0.5 * A.trace()))) return std::nullopt;
  return Vector2d(mean + A.inverse() * v);
}

/// The pair of landmarks furthest apart.
std::pair<std::size_t, std::size_t> widestPair(std::span<const KnownRange> ranges)
{
  std::pair<std::size_t, std::size_t> best{0, 0};
  double widest = -1;
  for (std::size_t i = 0; i < ranges.size(); ++i)
    for (std::size_t j = i + 1; j < ranges.size(); ++j)
      if (const double d = (ranges[i].landmark - ranges[j].landmark).norm(); d > widest)
      {
        widest = d;
        best = {i, j};
      }
  return best;
}

/// Inverse information; along a direction that no range sees, the width over which a ring bends away.
Matrix2d positionCovariance(std::span<const KnownRange> ranges, const NormalEquations<2>& model)
{
  const KnownRange& widest =
      *std::max_element(ranges.begin(), ranges.end(),
                        [](const KnownRange& a, const KnownRange& b) { return a.std * a.range < b.std * b.range; });
  const double bend2 = 2 * widest.std * std::max(widest.range, widest.std) + square(widest.std);
  const std::optional<Matrix2d> linear = covarianceFromInformation(model.hessian);
  if (linear && linear->trace() <= 4 * bend2) return *linear;
  return (model.hessian + Matrix2d::Identity() / bend2).inverse();
}

RangePosition polish(std::span<const KnownRange> ranges, Vector2d position)
{
  descend<2>(
      position, [&](const Vector2d& p) { return modelAt(ranges, p); },
      [&](const Vector2d& p) { return modelAt(ranges, p).cost; },
      [](const Vector2d& p, const Vector2d& step) { return Vector2d(p + step); });
  const NormalEquations<2> model = modelAt(ranges, position);
  RangePosition result;
  result.position = {position, positionCovariance(ranges, model)};
  result.chi2 = model.cost;
  for (const KnownRange& r : ranges) result.residuals.push_back((position - r.landmark).norm() - r.range);
  return result;
}
}  // namespace

RangePositions solveRangePosition(std::span<const KnownRange> ranges)
{
  RangePositions result;
  result.status = SolveStatus::bad_input;
  if (!std::all_of(ranges.begin(), ranges.end(), isUsableRange)) return result;
  result.status = SolveStatus::too_few;
  if (ranges.size() < 2) return result;

  const auto [i, j] = widestPair(ranges);
  const double extent = (ranges[i].landmark - ranges[j].landmark).norm();
  result.status = SolveStatus::degenerate;
  if (!(extent > 0)) return result;

  const TwoCircles circles =
      intersectCircles({ranges[i].landmark, ranges[i].range}, {ranges[j].landmark, ranges[j].range});
  std::vector<Vector2d> seeds(circles.candidates().begin(), circles.candidates().end());
  if (const std::optional<Vector2d> linear = linearSeed(ranges)) seeds.push_back(*linear);
  std::vector<RangePosition> found;
  for (const Vector2d& seed : seeds) found.push_back(polish(ranges, seed));
  std::stable_sort(found.begin(), found.end(),
                   [](const RangePosition& a, const RangePosition& b) { return a.chi2 < b.chi2; });
  for (RangePosition& candidate : found)
  {
    const auto same = [&](const RangePosition& other)
    { return (other.position.mean - candidate.position.mean).norm() <= kSamePlace * extent; };
    const bool rival = result.candidates.empty() || candidate.chi2 <= result.candidates.front().chi2 + kRivalChi2;
    if (rival && std::none_of(result.candidates.begin(), result.candidates.end(), same))
      result.candidates.push_back(std::move(candidate));
  }
  result.status = result.candidates.empty() ? SolveStatus::none : SolveStatus::ok;
  return result;
}
}  // namespace mrpt_ext
