#pragma once

#include <optional>
#include <string>

#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/importers/rosbag2/ros_messages.h"
#include "mrpt_ext/importers/rosbag2/transform_tree.h"

namespace mrpt_ext
{
/// Standard deviations of sensors whose messages state none; [Sensor_<label>] std_... replaces them.
struct RosSensorNoise
{
  double bearing = degToRad(0.5);            ///< [rad] of tags and objects
  double range = 0.05;                       ///< [m] of tags, objects and radios
  double range_per_m = 0.02;                 ///< of tags and objects, on top of it
  double reflector_bearing = degToRad(0.1);  ///< [rad]
  double reflector_range = 0.02;             ///< [m], also of each beam of a scan
};

/// Detections of one message as a reading in robot axes, free of the tilt of the sensor: `T_robot_sensor` is the pose
/// of the message's frame on the robot, and bearings are those of the projection onto the floor.

/// Tags: bearings through the pixel of the centre; a range where `transforms` hold the tag's pose at that time.
[[nodiscard]] Reading readingOf(const RosTags& message, const RosCamera& camera, const Pose3& T_robot_sensor,
                                const TransformTree& transforms, const RosSensorNoise& noise);
/// Objects with a position. A label that ends in a number is the landmark's id, any other label its category.
[[nodiscard]] Reading readingOf(const RosObjects& message, const Pose3& T_robot_sensor, const RosSensorNoise& noise);
/// Reflectors without names.
[[nodiscard]] Reading reflectorReadingOf(const RosObjects& message, const Pose3& T_robot_sensor,
                                         const RosSensorNoise& noise);
/// One range; without detection where nothing answered within the limits of the sensor. `id`: kNoId when not known.
[[nodiscard]] Reading readingOf(const RosRange& message, int id, const Pose3& T_robot_sensor,
                                const RosSensorNoise& noise);
[[nodiscard]] RangeScan scanRecordOf(RosScan message, const Pose3& T_robot_sensor, const RosSensorNoise& noise);

/// The number at the end of a name such as "tag36h11:7", "anchor_7" or "7"; nothing without one.
[[nodiscard]] std::optional<int> numberAtEnd(const std::string& name);
}  // namespace mrpt_ext
