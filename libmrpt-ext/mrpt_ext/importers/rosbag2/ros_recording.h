#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "mrpt_ext/importers/rosbag2/bag_message.h"
#include "mrpt_ext/importers/rosbag2/ros_messages.h"
#include "mrpt_ext/importers/rosbag2/transform_tree.h"

namespace mrpt_ext
{
/// The messages of a topic that can be used, in the order of the bag.
using RosSeries = std::variant<std::monostate, std::vector<RosPose>, std::vector<RosTags>, std::vector<RosCamera>,
                               std::vector<RosObjects>, std::vector<RosRange>, std::vector<RosScan>>;

struct RosTopic
{
  std::string type;
  std::size_t messages = 0;
  RosSeries series;    ///< monostate: of a type that is not read
  bool is_tf = false;  ///< its messages are in the tree of transforms
};

/// What a bag says about motion, sensors and landmarks.
struct RosRecording
{
  std::map<std::string, RosTopic> topics;  ///< by name
  TransformTree transforms;
  std::vector<std::string> notes;
};

/// Decodes messages into a recording, each type by its definition.
class RosCollector
{
 public:
  /// Throws DamagedBytes for a message of a type that is read, but cannot be.
  void take(const BagMessage& message);
  /// All of it, after the last message.
  [[nodiscard]] RosRecording finish();

 private:
  /// The definitions of a topic's messages, of which the first fits; more than one only where the bag has none.
  std::vector<MessageDefinition>& definitionsOf(const BagTopic& topic);

  RosRecording recording_;
  std::map<std::string, std::vector<MessageDefinition>> definitions_;  // by topic
};
}  // namespace mrpt_ext
