#pragma once

#include "mrpt_ext/correspondence/tree/interpretation_problem.h"

namespace mrpt_ext
{
/// Depth-first search for all consistent interpretations. Differences to the rule of paper 000, and why:
///- the first three bearings are the most widely spread ones: their pose has the smallest covariance;
///- the gate of a further bearing follows the uncertainty of the pose (InterpretationGate). Poses and gates come from
///  crossings of two rays in the plane of circle_inversion.h, where the bounds hold beyond first order;
///- nearly parallel rays (robot and landmarks nearly on one circle) leave a prefix open: the next bearing decides;
///- from four bearings on, every crossing of the newest ray with another must be consistent with all other matches and
///  with candidates for the remaining bearings; the crossing with the smallest bound is the pose;
///- checks that lose no solution: rays that do not meet, area, range limit, and the joint test (enough of the remaining
///  bearings must have a landmark within the gate);
///- up to `max_unmatched` bearings may stay unmatched. If one may, and there are six or more, two trees are searched:
/// one
///  with the first three bearings matched, and one from three others with one of the first three unmatched. Two initial
///  triples of bearings are fewer than the four of a single tree in which any bearing may stay unmatched.
/// Complete assignments are refined to their least-squares pose, from the crossing and, should that fail, from near
/// landmarks that may be close. Depth counts matched bearings; unmatched ones are not counted as nodes.
[[nodiscard]] InterpretationCandidates searchConsistent(const InterpretationProblem& problem);
}  // namespace mrpt_ext
