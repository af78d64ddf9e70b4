#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext
{
/// What one sensor measured of known landmarks from one place of the way.
struct WindowMeasurements
{
  /// Of the way from there to the robot now, as an error of the robot's pose now: (x, y, phi), robot axes.
  Matrix3d odometry_covariance = Matrix3d::Zero();
  /// T_robot_sensor: the sensor's place then, in the robot frame of now. std: of the sensor alone.
  std::vector<PoseMeasurement> measurements;
};

/// Maximum-likelihood pose at the end of a short way, from all that was measured along it, oldest first: refinePose
/// with the errors of odometry as what they are, shared (window_noise.h). Its covariance is that of a smoother over
/// all poses of the way; treating the carried measurements as independent with grown deviations instead (refinePose)
/// is over-confident, the more the more of them share a moment. With `odometry_covariance` zero everywhere it is
/// refinePose. Status as refinePose; `bad_input` also for a covariance that is not finite or has a negative diagonal.
[[nodiscard]] PoseMl refineCarriedPose(std::span<const WindowMeasurements> oldest_first, const Pose2& start,
                                       int max_iterations = 50);
}  // namespace mrpt_ext
