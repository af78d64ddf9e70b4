#pragma once

#include <map>
#include <string>
#include <vector>

#include "mrpt_ext/importers/rosbag2/ros_recording.h"

namespace mrpt_ext
{
/// Topics by role ("odometry", "truth", "detections", "scan"), as the user asks for them; "none": no topic.
using TopicRequests = std::map<std::string, std::vector<std::string>>;

/// ROLE=NAME, as --topic takes it. Throws InputError (configuration) for an unknown role.
void addTopicRequest(TopicRequests& requests, const std::string& text);

/// The topics to use.
struct TopicChoice
{
  std::string odometry;              ///< empty: none; a topic of transforms: the moving transform to the robot
  std::string truth;                 ///< empty: none
  std::vector<std::string> sensors;  ///< that detect landmarks
};

/// Chooses by type and name where nothing is asked for; `notes` takes what is used and ignored and why. Throws
/// InputError (configuration) for a requested topic that is not in the bag or of another type.
[[nodiscard]] TopicChoice chooseTopics(const RosRecording& bag, const TopicRequests& requests,
                                       std::vector<std::string>& notes);
}  // namespace mrpt_ext
