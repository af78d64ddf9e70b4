#pragma once

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// One step of a tracked robot.
struct BoundStep
{
  Pose2 increment;                                      ///< true motion in the body frame of the pose before
  Vector3d odometry_std{0, 0, 0};                       ///< of that increment [m, m, rad], body axes
  Matrix3d measurement_information = Matrix3d::Zero();  ///< sum J^T J / std^2 at the pose after the motion
  Matrix3d odometry_covariance = Matrix3d::Zero();      ///< added to odometry_std: correlated errors
};

/// Posterior Cramer-Rao bound of tracking along one fixed trajectory (Tichavsky, Muravchik, Nehorai 1998), in the
/// form J' = (Q + F J^-1 F^T)^-1 + information, which needs no inverse of Q and so allows noise-free axes.
/// `Q = G diag(std^2) G^T` depends on the heading; the extra heading information from dQ/dphi is left out, so the
/// bound is slightly too high when the two odometry axes differ much.
class BoundRecursion
{
 public:
  /// `prior`: the covariance at `start`, positive definite.
  BoundRecursion(const Pose2& start, const Matrix3d& prior) : pose_(start), covariance_(prior) {}
  /// The covariance bound after one more step.
  const Matrix3d& advance(const BoundStep& step);

 private:
  Pose2 pose_;
  Matrix3d covariance_;
};
}  // namespace mrpt_ext
