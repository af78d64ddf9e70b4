#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// Where a sensor sits on the robot.
struct SensorPose
{
  Pose2 T_robot_sensor;
  double height = 0;  ///< [m]
};

/// Reads `sensor,x,y,z,yaw_deg` [m, deg]: one row per sensor; x forward, y to the left, z above the floor, yaw
/// counter-clockwise from the forward axis.
/// Throws InputError (data) on wrong columns, damaged rows and a sensor that occurs twice.
[[nodiscard]] std::map<std::string, SensorPose> readSensorPoses(const std::filesystem::path& path);

/// Gives all readings the poses of their sensors, and notes sensors without readings. Throws InputError (data), naming
/// the file, for a reading of a sensor that has no pose.
void mountSensors(Recording& recording, const std::filesystem::path& path);
}  // namespace mrpt_ext
