#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// Bearings of the first and the last beam of a scanner [rad], counter-clockwise from its forward axis.
struct BeamSpan
{
  double first = 0, last = 0;
};

/// Where a sensor sits on the robot.
struct SensorPose
{
  Pose2 T_robot_sensor;
  double height = 0;              ///< [m]
  std::optional<BeamSpan> beams;  ///< of a laser scanner
};

/// Reads `sensor,x,y,z,yaw_deg` [m, deg]: one row per sensor; x forward, y to the left, z above the floor, yaw
/// counter-clockwise from the forward axis. Optional columns `first_bearing_deg,last_bearing_deg`: of a scanner's
/// beams. Throws InputError (data) on wrong columns, damaged rows and a sensor that occurs twice.
[[nodiscard]] std::map<std::string, SensorPose> readSensorPoses(const std::filesystem::path& path);

/// Makes the pose of a sensor the robot's frame: odometry and all sensors are expressed in it. The truth stays.
void setRobotFrame(Recording& recording, const SensorPose& frame);

/// Gives all readings the poses of their sensors, and notes sensors without readings. Throws InputError (data), naming
/// the file, for a reading of a sensor that has no pose.
void mountSensors(Recording& recording, const std::map<std::string, SensorPose>& poses,
                  const std::filesystem::path& path);
}  // namespace mrpt_ext
