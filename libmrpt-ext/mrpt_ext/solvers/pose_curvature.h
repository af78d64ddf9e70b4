#pragma once

#include "mrpt_ext/solvers/pose_residuals.h"

namespace mrpt_ext
{
/// How far the parabola about a maximum-likelihood pose can be believed. The error of the estimate is, to second order,
/// e + d with e ~ N(0, P), P the inverse information, and d = -P sum_i w_i J_i^T (e^T H_i e) / 2 (Box 1971; Bates and
/// Watts 1980), H_i the second derivative of measurement i.
struct PoseCurvature
{
  double rms = 0;  ///< root mean square of d in standard deviations of e: above about 1 the linearisation means nothing
  Matrix3d second_moment = Matrix3d::Zero();  ///< E[d d^T]; P + this is the mean square error to second order
  Vector3d weakest = Vector3d::Zero();        ///< error of one standard deviation where the position is known worst
  Vector3d bend = Vector3d::Zero();           ///< d for that error
};

/// At `pose` with covariance `P` (positive definite).
[[nodiscard]] PoseCurvature poseCurvature(const PoseResiduals& rows, const Pose2& pose, const Matrix3d& P);
}  // namespace mrpt_ext
