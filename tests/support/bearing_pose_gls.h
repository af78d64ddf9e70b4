#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/solvers/known_bearing.h"

namespace mrpt_ext
{
struct BearingPoseGls
{
  SolveStatus status = SolveStatus::too_few;
  Pose2 pose;                     ///< heading as weighted circular mean over all landmarks; set only when ok
  Vector2d f{0, 0};               ///< 1 / (L_0 - R) as a complex number [1/m]
  double det_ratio = 0;           ///< det(S) / (n-1)^2 of the linear form, in [0, 1/4]
  std::vector<double> residuals;  ///< predicted minus measured bearing [rad]; empty without a pose
};

/// Generalised least squares in the f-space of paper 000: the linear form (bearing_pose_linear) with the right
/// weights, still a 2x2 inverse per iteration. The residual n_i . (f + b'_i) has the error g_i (e_i - e_0) with
/// g_i = |f + b'_i|, so W = (D (Sigma + sigma_0^2 1 1^T) D)^-1, D = diag(g_i); the paper (eq 4, 11) takes W = I, which
/// ignores both g_i and the shared error of landmark 0. By Sherman-Morrison no large inverse is needed.
/// Close to the Cramer-Rao limit; status as in bearing_pose_linear, `behind` judged at the refined f.
[[nodiscard]] BearingPoseGls solveBearingPoseGls(std::span<const KnownBearing> bearings, int iterations = 3);
}  // namespace mrpt_ext
