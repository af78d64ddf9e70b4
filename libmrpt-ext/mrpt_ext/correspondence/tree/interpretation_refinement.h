#pragma once

#include "mrpt_ext/correspondence/tree/bearing_least_squares.h"
#include "mrpt_ext/correspondence/tree/circle_inversion.h"
#include "mrpt_ext/correspondence/tree/interpretation_problem.h"

namespace mrpt_ext
{
/// Refines an assignment to its least-squares pose; nothing when it is not consistent. `matched`: its bearings, the
/// reference of `base` first. `base`: a crossing of two of their rays; if it is open, the bearings alone give the
/// start. Should the descent from there fail, it starts near landmarks that may be close.
[[nodiscard]] std::optional<Interpretation> refineInterpretation(const InterpretationProblem& problem,
                                                                 const std::vector<int>& assignment,
                                                                 std::span<const MatchedBearing> matched,
                                                                 const RayCrossing& base);
}  // namespace mrpt_ext
