#pragma once

#include "mrpt_ext/correspondence/tree/interpretation_problem.h"

namespace mrpt_ext
{
/// Depth-first search for all consistent interpretations. Differences to the paper's rule, and why:
/// - the first three bearings are the best spread ones, not the first given: their pose is the most certain;
/// - a further bearing must lie within the gate that the uncertainty of the pose leaves (InterpretationGate). Poses and
///   gates come from crossings of two rays in the plane of circle_inversion.h, where the bounds hold beyond first
///   order;
/// - nearly parallel rays (robot and landmarks nearly on one circle) leave a prefix open: the next bearing decides;
/// - from four bearings on, every crossing of the newest ray with another must explain all the others, and the
///   candidates of the bearings to come; the most certain one is the pose;
/// - checks that lose no solution: rays that do not meet, area, range limit, and the joint test (enough of the bearings
///   still to come must have some landmark within the gate);
/// - a bearing may stay unmatched, as often as `max_unmatched`. If one may, and there are six or more, the tree is
/// grown
///   twice: with the first three bearings matched, and from three others, with one of the first three unmatched. Two
///   triples of bearings to begin with are fewer than the four that a tree needs which may leave out any.
/// What is left is refined to its least-squares pose, from the crossing and, should that fail, from beside landmarks
/// that may be close. Depth counts matched bearings; unmatched ones are not counted as nodes.
[[nodiscard]] InterpretationCandidates searchConsistent(const InterpretationProblem& problem);
}  // namespace mrpt_ext
