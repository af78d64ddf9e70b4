#pragma once

#include "mrpt_ext/correspondence/interpretation_problem.h"

namespace mrpt_ext
{
/// Depth-first search for all consistent interpretations. Differences to the paper's rule, and why:
/// - the first three bearings are the best spread ones, not the first given: their pose is the most certain;
/// - a further bearing must lie within the gate that the uncertainty of the prefix pose leaves (InterpretationGate);
/// - from four bearings on the prefix pose is the least-squares pose, and its residuals must fit sum <= p eps^2;
/// - a triple that is singular or "behind" within the bearings' error is not dropped but decided by a further bearing;
/// - checks that lose no solution: circular order of the first three, area, range limit, and the joint test (enough of
///   the bearings still to come must have some landmark within the gate);
/// - a bearing may stay unmatched, as often as `max_unmatched`.
/// Depth counts matched bearings; unmatched ones are not counted as nodes.
[[nodiscard]] InterpretationCandidates searchConsistent(const InterpretationProblem& problem);

/// Order in which bearings are matched: first the three with the largest smallest gap between them (of nearly equal
/// triples the one with fewest combinations of allowed landmarks), then those furthest from the ones before.
[[nodiscard]] std::vector<int> spreadOrder(const InterpretationProblem& problem);
}  // namespace mrpt_ext
