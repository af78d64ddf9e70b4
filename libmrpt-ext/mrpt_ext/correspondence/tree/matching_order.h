#pragma once

#include "mrpt_ext/correspondence/tree/interpretation_problem.h"

namespace mrpt_ext
{
/// In which order bearings are matched, and which may stay unmatched.
struct MatchingOrder
{
  std::vector<int> order;     ///< scans: first the three that fix the pose
  std::size_t skip_from = 0;  ///< scan from where on bearings may stay unmatched
  std::size_t least_skipped = 0, max_skipped = 0;
};

/// Plans that find every interpretation once. Order: first the three bearings with the largest smallest gap between
/// them (of nearly equal triples the one with fewest combinations of allowed landmarks), then those furthest from the
/// ones before. If one of six or more may stay unmatched there are two plans: one for the first three matched, and one
/// from three others for one of the first three unmatched. Two triples of bearings to begin with are fewer than the
/// four that a tree needs which may leave out any.
[[nodiscard]] std::vector<MatchingOrder> matchingOrders(const InterpretationProblem& problem);
}  // namespace mrpt_ext
