#pragma once

#include "mrpt_ext/correspondence/tree/interpretation_problem.h"

namespace mrpt_ext
{
/// The search of paper 000, section 3, to the letter. Bearings in the order given, all matched; depth 3: the pose by
/// eq 1-6 exists (S not singular, r_1, r_2 > 0); deeper: |predicted - measured| <= eps from the pose of the accepted
/// prefix, then that pose is computed anew and must exist. No area, no range limit, no unmatched bearings.
/// It loses the truth under noise (recall 0.4 to 0.7 at eps = 3.3 sigma), because the three-bearing pose has its own
/// error; kept by name for comparison. Its interpretations hold the closed-form pose with the covariance that a
/// maximum-likelihood pose there would have. With InterpretationRule::paper_in_order, children that contradict the
/// circular order of the bearings are not compared at all (the paper's angular order; it loses nothing further).
[[nodiscard]] InterpretationCandidates searchByPaperRule(const InterpretationProblem& problem);
}  // namespace mrpt_ext
