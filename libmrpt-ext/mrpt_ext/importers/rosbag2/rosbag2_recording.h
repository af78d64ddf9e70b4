#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/importers/rosbag2/topic_choice.h"

namespace mrpt_ext
{
struct Rosbag2Options
{
  TopicRequests topics;
  std::string base;           ///< frame of the robot; empty: that of the odometry, else base_link
  std::filesystem::path map;  ///< of the landmarks, see landmark_map_file.h; empty: none
};

/// A recording of ROS 2's rosbag2, without ROS: folder or files, see bag_files.h. Sensors are where /tf_static puts
/// them; their labels are the names of their topics, "camera_detections" for /camera/detections. Throws InputError.
[[nodiscard]] Recording importRosbag2(const std::vector<std::filesystem::path>& inputs, const Rosbag2Options& options);
}  // namespace mrpt_ext
