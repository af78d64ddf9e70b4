#pragma once

#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// Of odometry when wheels slip: x, y [m], phi [rad].
inline const Vector3d kSlipStd{0.3, 0.3, degToRad(25.0)};

/// A pose that odometry predicts, if wheels may have slipped.
[[nodiscard]] inline GaussianPose afterSlip(GaussianPose pose)
{
  pose.covariance.diagonal() += kSlipStd.cwiseAbs2();
  return pose;
}

/// When, and how strongly, a filter injects hypotheses.
struct RecoveryOptions
{
  double reseed_inlier_ratio = 0.5;       ///< below this inlier ratio (relative to what is expected) it injects
  double lost_inlier_ratio = 0.3;         ///< below this the verdict is `lost`
  double injected_particle_share = 0.25;  ///< particles of one injection, relative to the particle count
  double relocalization_prior = 0.02;     ///< probability per injection that the robot is somewhere else
  double min_interval = 0.5;              ///< [s] between two injections, which are costly
  double slip_share = 0.5;                ///< share of relocalizations that are slips of odometry; others go anywhere
};
}  // namespace mrpt_ext
