#pragma once

#include <span>

#include "mrpt_ext/solvers/known_bearing.h"
#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext
{
/// Maximum-likelihood pose from n >= 3 bearings to known landmarks: minimises the sum of (wrap(predicted - measured) /
/// sigma_i)^2 from the closed forms of paper 000, corrected (bearing_pose_linear, bearing_pose_gls). When both fail
/// with landmark 0 as reference (noise can turn a bearing "behind"), the other references are tried; so a pose is
/// found whenever one of the closed forms finds one. `det_ratio` of the result is informationRatio.
/// Status: that of the linear form when no closed form has a pose; `behind` when a residual at the solution exceeds a
/// right angle; `degenerate` when the information there is singular.
[[nodiscard]] PoseMl solveBearingPoseMl(std::span<const KnownBearing> bearings, const PoseMlOptions& options = {});
}  // namespace mrpt_ext
