#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/geometry/path_moments.h"
#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// Motion between two times by odometry, with what the noise model needs to know about the trajectory between them.
struct OdometryMotion
{
  Pose2 increment;                     ///< later pose in the frame of the earlier one
  double path_length = 0;              ///< [m] along the trajectory
  double turned = 0;                   ///< [rad] sum of absolute heading changes
  double duration = 0;                 ///< [s]
  Matrix3d excess = Matrix3d::Zero();  ///< covariance of the increment [m^2, m rad, rad^2] beyond the stated noise
  std::optional<PathMoments> moments;  ///< absent: turn, length and time pass evenly along the increment
};

[[nodiscard]] inline PathMoments momentsOf(const OdometryMotion& motion)
{
  if (motion.moments) return *motion.moments;
  return momentsOf(PathPiece{motion.increment, motion.path_length, motion.turned, motion.duration});
}

/// The detections of all sensors at (nearly) one time: the input of every localizer.
/// The sensor poses of earlier readings are moved to `time` by odometry.
struct Frame
{
  double time = 0;        ///< [s] stamp of the last reading
  OdometryMotion motion;  ///< since the previous frame (identity for the first)
  std::vector<Reading> readings;
  std::vector<RunningFixReading> fixes;
  std::optional<CompassRecord> compass;
};

/// True when some detection of the frame is anonymous.
[[nodiscard]] inline bool hasAnonymous(const Frame& frame)
{
  return std::any_of(frame.readings.begin(), frame.readings.end(),
                     [](const Reading& reading) { return hasAnonymous(reading); });
}
}  // namespace mrpt_ext
