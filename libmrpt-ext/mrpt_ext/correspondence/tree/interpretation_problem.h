#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/tree/interpretation_types.h"

namespace mrpt_ext
{
/// Checked input of a search: every bearing has its list of landmarks.
struct InterpretationProblem
{
  std::span<const Vector2d> landmarks;
  std::vector<double> bearings;           ///< wrapped [rad]
  std::vector<std::vector<int>> allowed;  ///< landmark indices per bearing
  const InterpretationOptions& options;

  [[nodiscard]] double stdBearing() const { return options.std_bearing.value_or(options.max_residual / 3.3); }
  [[nodiscard]] int minimumMatched() const
  {
    const int wanted = static_cast<int>(bearings.size()) - options.max_unmatched;
    return std::max(wanted, options.allow_three ? 3 : 4);
  }
};

/// Result of a search, before the interpretations are ranked.
struct InterpretationCandidates
{
  std::vector<Interpretation> found;
  std::vector<std::uint64_t> tested, valid;  ///< index 0: depth 3
  bool finished = true;
};

/// Refines the pose of a complete assignment from `start` to its maximum likelihood and fills in the figures; nothing
/// when it is not consistent (residual above eps, outside the area, out of range, or degenerate).
[[nodiscard]] std::optional<Interpretation> verifyInterpretation(const InterpretationProblem& problem,
                                                                 const std::vector<int>& assignment,
                                                                 const Pose2& start);
}  // namespace mrpt_ext
