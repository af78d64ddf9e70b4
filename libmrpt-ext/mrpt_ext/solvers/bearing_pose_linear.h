#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/solvers/bearing_pose_from_units.h"
#include "mrpt_ext/solvers/known_bearing.h"

namespace mrpt_ext
{
struct BearingPoseLinear
{
  SolveStatus status = SolveStatus::too_few;
  Pose2 pose;                     ///< heading from landmark 0 (eq 6); set only when status is ok
  double mean_phi = 0;            ///< heading as circular mean over all landmarks; set only when status is ok
  Vector2d f{0, 0};               ///< 1 / (L_0 - R) as a complex number [1/m]
  std::vector<double> r;          ///< |L_i - R| / |L_0 - R| for i = 1..n-1; <= 0: landmark i would lie behind
  double det_ratio = 0;           ///< det(S) / (n-1)^2, in [0, 1/4]: quality of the geometry
  std::vector<double> residuals;  ///< predicted minus measured bearing at `pose` [rad]; empty without a pose
};

/// Pose from n >= 3 bearings to known landmarks by the linear least squares of paper 000, eq 1-6. Landmark 0 is the
/// reference. In complex numbers, with a_i = exp(j (b_i - b_0)) / (L_i - L_0), b'_i = 1 / (L_i - L_0) and unit normals
/// n_i of a_i:  S f = -sum n_i (n_i . b'_i),  R = L_0 - 1/f,  heading = arg(L_0 - R) - b_0.
/// Deviations: theta_0 for the paper's theta_b (eq 1), atan2 for tan^-1 (eq 6). Only differences of landmarks enter, so
/// large map coordinates cost no digits.
/// It weighs far landmarks and those close to landmark 0 most and gets relatively worse with more landmarks: it is a
/// seed for bearing_pose_ml, not an estimator.
/// Status: `behind` when a directed bearing points away from its landmark (the paper's "pose solution existence");
/// `degenerate` when S is singular, or a landmark coincides with landmark 0.
[[nodiscard]] BearingPoseLinear solveBearingPoseLinear(std::span<const KnownBearing> bearings);
}  // namespace mrpt_ext
