#pragma once

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Pose with covariance, order (x, y, phi) [m, m, rad], world axes.
struct GaussianPose
{
  Pose2 mean;
  Matrix3d covariance = Matrix3d::Zero();
};

/// T_a_c from an uncertain T_a_b and an independent T_b_c with covariance `noise` (axes of b), to first order: the
/// compounding of Smith, Self and Cheeseman, "Estimating uncertain spatial relationships in robotics", 1990.
[[nodiscard]] inline GaussianPose compound(const GaussianPose& T_a_b, const Pose2& T_b_c,
                                           const Matrix3d& noise = Matrix3d::Zero())
{
  const Matrix3d J = composeJacobianFirst(T_a_b.mean, T_b_c), G = composeJacobianSecond(T_a_b.mean);
  return {compose(T_a_b.mean, T_b_c), J * T_a_b.covariance * J.transpose() + G * noise * G.transpose()};
}
}  // namespace mrpt_ext
