#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/solvers/range_position.h"

namespace mrpt_ext
{
inline constexpr double kRangeGate = 3;  ///< a range is an inlier when |residual| <= kRangeGate * std

struct RobustRangePosition
{
  RangePosition fit;          ///< maximum likelihood of the inliers; residuals of all ranges
  std::vector<bool> inliers;  ///< one per given range
  int inlier_count = 0;
  double cost = 0;  ///< sum over all ranges of min(e^2, kRangeGate^2), e = residual / std
};

struct RobustRangePositions
{
  SolveStatus status = SolveStatus::too_few;
  std::vector<RobustRangePosition> candidates;  ///< lowest cost first; all that agree with as many ranges as the best
};

/// Position from ranges of which some may be grossly wrong (reflections, a wrong beacon): every pair of ranges proposes
/// its two positions, each position is judged by the truncated cost over all ranges (exhaustive minimal subsets:
/// nothing is drawn at random), the best are refined on their inliers until these settle. With k good ranges of n >= 4
/// the truth is found when k >= 3; three ranges of which one is wrong cannot tell which, and all their candidates are
/// returned.
[[nodiscard]] RobustRangePositions solveRangePositionRobust(std::span<const KnownRange> ranges);
}  // namespace mrpt_ext
