#pragma once

#include "mrpt_ext/correspondence/tree/interpretation_problem.h"

namespace mrpt_ext
{
/// The order in which bearings are matched, and which of them may stay unmatched.
struct MatchingOrder
{
  std::vector<int> bearings;  ///< first the three that determine the pose
  std::size_t skip_from = 0;  ///< step from which on bearings may stay unmatched
  std::size_t least_skipped = 0, max_skipped = 0;
};

/// Orders that together find every interpretation once: first the three bearings with the largest smallest gap between
/// them (of nearly equal triples the one with fewest combinations of allowed landmarks), then those farthest from the
/// ones before. If one of six or more may stay unmatched there are two orders: one for the first three matched, and one
/// from three others for one of the first three unmatched (see interpretation_search.h).
[[nodiscard]] std::vector<MatchingOrder> matchingOrders(const InterpretationProblem& problem);
}  // namespace mrpt_ext
