#pragma once

#include <vector>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// One step of a tracked robot, as the bound sees it.
struct BoundStep
{
  Pose2 increment;                                      ///< true motion in the body frame of the pose before
  Vector3d odometry_std{0, 0, 0};                       ///< of that increment [m, m, rad], body axes
  Matrix3d measurement_information = Matrix3d::Zero();  ///< sum J^T J / std^2 at the pose after the motion
  Matrix3d odometry_covariance = Matrix3d::Zero();      ///< added to odometry_std: errors that belong together
};

/// Covariance bound of a tracked robot, step by step along its true way; see posteriorBound().
class BoundRecursion
{
 public:
  BoundRecursion(const Pose2& start, const Matrix3d& prior) : pose_(start), covariance_(prior) {}
  /// The bound after one more step.
  const Matrix3d& advance(const BoundStep& step);

 private:
  Pose2 pose_;
  Matrix3d covariance_;
};

/// Posterior Cramer-Rao bound of tracking along one fixed trajectory (Tichavsky, Muravchik, Nehorai 1998), in the
/// form J' = (Q + F J^-1 F^T)^-1 + information, which needs no inverse of Q and so allows noise-free axes.
/// `Q = G diag(std^2) G^T` depends on the heading; the extra heading information from dQ/dphi is left out, so the
/// bound is slightly too high when the two odometry axes differ much.
/// `prior` is the covariance at `start`, positive definite. Returns the covariance bound after each step.
[[nodiscard]] std::vector<Matrix3d> posteriorBound(const Pose2& start, const Matrix3d& prior,
                                                   const std::vector<BoundStep>& steps);
}  // namespace mrpt_ext
