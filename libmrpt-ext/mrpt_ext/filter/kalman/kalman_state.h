#pragma once

#include <Eigen/Core>

#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/geometry/bias_model.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// The pose and at most this many systematic errors: no heap memory.
inline constexpr int kMaxKalmanStates = 16;

using KalmanVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxKalmanStates, 1>;
using KalmanRowVector = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMaxKalmanStates>;
using KalmanMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxKalmanStates, kMaxKalmanStates>;

/// Gaussian state: x, y [m], phi [rad, wrapped], then the systematic errors in the order of the model. The covariance
/// is symmetric and positive definite.
struct KalmanState
{
  KalmanVector mean = KalmanVector::Zero(3);
  KalmanMatrix covariance = KalmanMatrix::Identity(3, 3);

  [[nodiscard]] Pose2 pose() const { return {mean[0], mean[1], mean[2]}; }
  [[nodiscard]] GaussianPose gaussianPose() const { return {pose(), covariance.topLeftCorner<3, 3>()}; }
};

/// The pose as given, the errors with their prior, uncorrelated. A standard deviation of zero is raised to one
/// millionth of a unit, so that the covariance can be inverted.
[[nodiscard]] KalmanState startingState(const GaussianPose& pose, const BiasModel& biases);

/// The state after a motion measured by odometry. The scale errors multiply distance and rotation (the chord of an arc
/// turns by half of what the rotation grows); incrementCovariance() is added in the axes of the robot, and the random
/// walk of the errors.
[[nodiscard]] KalmanState predict(const KalmanState& state, const BiasModel& biases, const MotionModel& model,
                                  const OdometryMotion& motion);

/// Derivative of the state after a motion by the state before it, at the state before it.
[[nodiscard]] KalmanMatrix motionJacobian(const KalmanState& state, const BiasModel& biases, const MotionModel& model,
                                          const OdometryMotion& motion);

/// mean + step, heading wrapped.
[[nodiscard]] KalmanVector moved(const KalmanVector& mean, const KalmanVector& step);
}  // namespace mrpt_ext
