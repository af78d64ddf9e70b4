#pragma once

#include <functional>
#include <vector>

#include "mrpt_ext/hypotheses/proposal.h"

namespace mrpt_ext
{
/// Who a particle filter asks for pose hypotheses, and what it is given to rejuvenate its particles with. All optional.
struct HypothesisSources
{
  /// Hypotheses from the closed-form solvers; asked only at initialization and for recovery.
  std::function<Proposal()> closed_forms;
  /// Hypotheses for the newest frame from a search over the recent trajectory. Their weights come from all measurements
  /// along it and sum to 1 at most; the best modes of the filter are among them. Empty: nothing new.
  std::function<HypothesisSet()> trajectory;
  /// All readings since the start, transformed to the newest frame, as long as odometry between them is more precise
  /// than they are; else empty.
  std::vector<Reading> since_start;
};
}  // namespace mrpt_ext
