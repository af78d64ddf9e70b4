#pragma once

#include <span>

#include "mrpt_ext/solvers/known_bearing.h"
#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext
{
/// Maximum-likelihood pose from n >= 3 bearings to known landmarks: minimises the sum of (wrap(predicted - measured) /
/// sigma_i)^2 from paper 000 for triples of the bearings (minimal_solvers.h), of which all bearings choose the best: no
/// single landmark is trusted as the reference. Where no triple has a pose, the linear form of all bearings
/// (bearing_pose_linear) may. `det_ratio` of the result is informationRatio. Where the pose may be ambiguous or in
/// doubt, solvePoseFromLandmarks tells more. Status: that of the linear form when no closed form has a pose; `behind`
/// when a residual at the solution exceeds a right angle; `degenerate` when the information there is singular.
[[nodiscard]] PoseMl solveBearingPoseMl(std::span<const KnownBearing> bearings);
}  // namespace mrpt_ext
