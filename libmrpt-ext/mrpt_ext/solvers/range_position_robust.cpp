#include "mrpt_ext/solvers/range_position_robust.h"

#include <algorithm>
#include <optional>

#include "mrpt_ext/solvers/two_circles.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kRefined = 8;  // proposals that are worth refining
constexpr int kSettleRounds = 5;
constexpr double kSameResult = 1e-6;

struct Proposal
{
  Vector2d position;
  double cost;
};

double truncatedCost(std::span<const KnownRange> ranges, const Vector2d& position)
{
  double sum = 0;
  for (const KnownRange& r : ranges)
    sum += std::min(square(((position - r.landmark).norm() - r.range) / r.std), square(kRangeGate));
  return sum;
}

std::vector<bool> inliersAt(std::span<const KnownRange> ranges, const Vector2d& position)
{
  std::vector<bool> inliers;
  for (const KnownRange& r : ranges)
    inliers.push_back(std::abs((position - r.landmark).norm() - r.range) <= kRangeGate * r.std);
  return inliers;
}

/// The candidates of every pair of ranges, best first.
std::vector<Proposal> propose(std::span<const KnownRange> ranges)
{
  std::vector<Proposal> proposals;
  const auto add = [&](const Vector2d& p) { proposals.push_back({p, truncatedCost(ranges, p)}); };
  for (std::size_t i = 0; i < ranges.size(); ++i)
    for (std::size_t j = i + 1; j < ranges.size(); ++j)
    {
      const TwoCircles circles =
          intersectCircles({ranges[i].landmark, ranges[i].range}, {ranges[j].landmark, ranges[j].range});
      for (const Vector2d& p : circles.candidates()) add(p);
    }
  std::stable_sort(proposals.begin(), proposals.end(),
                   [](const Proposal& a, const Proposal& b) { return a.cost < b.cost; });
  return proposals;
}

/// Candidate of `solution` nearest to `position`.
const RangePosition& nearest(const RangePositions& solution, const Vector2d& position)
{
  return *std::min_element(
      solution.candidates.begin(), solution.candidates.end(),
      [&](const RangePosition& a, const RangePosition& b)
      { return (a.position.mean - position).squaredNorm() < (b.position.mean - position).squaredNorm(); });
}

/// Refines a proposal on its inliers until they no longer change; nothing when less than two remain.
std::optional<RobustRangePosition> settle(std::span<const KnownRange> ranges, const Proposal& proposal)
{
  RobustRangePosition result;
  Vector2d position = proposal.position;
  std::vector<bool> inliers = inliersAt(ranges, position);
  for (int round = 0; round < kSettleRounds; ++round)
  {
    std::vector<KnownRange> chosen;
    for (std::size_t i = 0; i < ranges.size(); ++i)
      if (inliers[i]) chosen.push_back(ranges[i]);
    const RangePositions solution = solveRangePosition(chosen);
    if (solution.status != SolveStatus::ok) return std::nullopt;
    result.fit = nearest(solution, position);
    position = result.fit.position.mean;
    result.inliers = inliers;
    inliers = inliersAt(ranges, position);
    if (inliers == result.inliers) break;
  }
  result.inlier_count = static_cast<int>(std::count(result.inliers.begin(), result.inliers.end(), true));
  result.cost = truncatedCost(ranges, position);
  result.fit.residuals.clear();
  for (const KnownRange& r : ranges) result.fit.residuals.push_back((position - r.landmark).norm() - r.range);
  return result;
}
}  // namespace

RobustRangePositions solveRangePositionRobust(std::span<const KnownRange> ranges)
{
  RobustRangePositions result;
  result.status = solveRangePosition(ranges).status;
  if (result.status != SolveStatus::ok) return result;

  const std::vector<Proposal> proposals = propose(ranges);
  std::vector<RobustRangePosition> settled;
  for (std::size_t k = 0; k < std::min(proposals.size(), kRefined); ++k)
  {
    std::optional<RobustRangePosition> candidate = settle(ranges, proposals[k]);
    const auto same = [&](const RobustRangePosition& other)
    {
      const double distance = (other.fit.position.mean - candidate->fit.position.mean).norm();
      return distance <= kSameResult * (1 + candidate->fit.position.mean.norm());
    };
    if (candidate && std::none_of(settled.begin(), settled.end(), same)) settled.push_back(std::move(*candidate));
  }
  std::stable_sort(settled.begin(), settled.end(),
                   [](const RobustRangePosition& a, const RobustRangePosition& b) { return a.cost < b.cost; });
  for (RobustRangePosition& candidate : settled)
    if (candidate.inlier_count >= settled.front().inlier_count) result.candidates.push_back(std::move(candidate));
  result.status = result.candidates.empty() ? SolveStatus::none : SolveStatus::ok;
  return result;
}
}  // namespace mrpt_ext
