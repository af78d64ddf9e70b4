#pragma once

#include "mrpt_ext/filter/kalman/kalman_state.h"

namespace mrpt_ext
{
/// Steps of a state as rigid motions of the plane about the robot: a turn by the angle moves the position along the arc
/// that starts as told, instead of along its tangent. All poses that see one landmark alike are then a straight line of
/// steps, and its readings, which tell nothing along it, tell nothing along it at any pose the state is linearised at.
/// With plain steps the line turns from pose to pose, and a filter that has moved along it takes that for information
/// it never got (Huang, Mourikis and Roumeliotis, Int. J. Robotics Research 29(5), 2010). Systematic errors are added.
/// The exponential map of SE(2), applied from the left (Sola et al., arXiv:1812.01537; as an update of a Kalman filter:
/// Barrau and Bonnabel, IEEE Trans. Autom. Control 62(4), 2017). What odometry does to an error is linear in such steps
/// anyway.

/// `mean` after the step (x, y [m], phi [rad], systematic errors); heading wrapped.
[[nodiscard]] KalmanVector movedRigidly(const KalmanVector& mean, const KalmanVector& step);

/// The step with movedRigidly(from, step) = to; turns by half a circle at most.
[[nodiscard]] KalmanVector rigidStep(const KalmanVector& from, const KalmanVector& to);

/// Derivative of the further step, from the state after `step`, by a change of `step`.
[[nodiscard]] KalmanMatrix rigidStepJacobian(const KalmanVector& step);

/// The covariance of steps from a state as that of steps from where `step` leads: motions of the plane that are told
/// about another point. What moves the robot about a landmark before the step does so after it, whatever the step.
[[nodiscard]] KalmanMatrix transported(const KalmanMatrix& covariance, const KalmanVector& step);
}  // namespace mrpt_ext
