#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/evaluation/scoring.h"

namespace mrpt_ext
{
/// What makes estimates differ from the truth by one and the same displacement.
enum class TruthOffset
{
  none,  ///< nothing of this kind: other errors prevail
  map,   ///< truth = T estimate: the truth is in another frame than the map
  robot  ///< truth = estimate T: the truth is of another point of the robot
};

struct TruthOffsetFinding
{
  TruthOffset kind = TruthOffset::none;
  Pose2 T;              ///< for `robot` a position alone
  double residual = 0;  ///< [m] root mean square of what is left
};

/// Compares the estimates that are `ok` with the truth. A displacement counts where it explains nearly all of their
/// squared position error. For words about the truth alone: no figure changes by it.
[[nodiscard]] TruthOffsetFinding findTruthOffset(const std::vector<JudgedEstimate>& judged);

/// One line for the reader; empty for `none`.
[[nodiscard]] std::string truthOffsetHint(const TruthOffsetFinding& finding);
}  // namespace mrpt_ext
