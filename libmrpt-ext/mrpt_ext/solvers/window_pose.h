#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/solvers/pose_ml.h"

namespace mrpt_ext
{
/// Measurements of known landmarks by one sensor at one time of the window.
struct WindowMeasurements
{
  /// Covariance of odometry since that time, as an error (x, y, phi) of the present pose, robot axes.
  Matrix3d odometry_covariance = Matrix3d::Zero();
  /// T_robot_sensor: pose of the sensor at that time, in the present robot frame. std: of the sensor alone.
  std::vector<PoseMeasurement> measurements;
};

/// Maximum-likelihood present pose from all measurements of a window, oldest first: refinePose with the errors of
/// odometry that the measurements share (window_noise.h). The covariance is that of a smoother over all poses of the
/// window; counting the measurements as independent, with larger standard deviations, would be overconfident, the more
/// of them share a time. With `odometry_covariance` zero everywhere it is refinePose. Status as refinePose; `bad_input`
/// also for a covariance that is not finite or has a negative diagonal.
[[nodiscard]] PoseMl refineWindowPose(std::span<const WindowMeasurements> oldest_first, const Pose2& start);
}  // namespace mrpt_ext
