#include "mrpt_ext/importers/rosbag2/ros_recording.h"

#include <functional>

#include "mrpt_ext/importers/rosbag2/byte_reader.h"
#include "mrpt_ext/importers/rosbag2/well_known_definitions.h"

namespace mrpt_ext
{
namespace
{
/// What is done with a message of a type.
using Taker = std::function<void(const MessageValue&, double recorded, RosTopic&, TransformTree&)>;

/// Messages without a stamp count at the time of their recording.
void stamp(RosHeader& header, double recorded)
{
  if (header.time == 0) header.time = recorded;
}

template <typename Plain, Plain (*read)(const MessageValue&)>
void append(const MessageValue& message, double recorded, RosTopic& topic, TransformTree&)
{
  if (topic.series.index() == 0) topic.series = std::vector<Plain>();
  Plain plain = read(message);
  stamp(plain.header, recorded);
  std::get<std::vector<Plain>>(topic.series).push_back(std::move(plain));
}

void appendCamera(const MessageValue& message, double, RosTopic& topic, TransformTree&)
{
  if (topic.series.index() == 0) topic.series = std::vector<RosCamera>();
  auto& cameras = std::get<std::vector<RosCamera>>(topic.series);
  // A camera repeats itself; it does not change while a bag is recorded.
  if (const auto camera = cameraIn(message); camera && cameras.empty()) cameras.push_back(*camera);
}

void addTransforms(const MessageValue& message, double recorded, RosTopic& topic, TransformTree& tree)
{
  topic.is_tf = true;
  for (const MessageValue& one : message.list("transforms"))
  {
    RosPose transform = transformIn(one);
    stamp(transform.header, recorded);
    tree.add(transform);
  }
}

const Taker* takerOf(const std::string& type)
{
  static const std::map<std::string, Taker> kTakers = {
      {"nav_msgs/Odometry", append<RosPose, odometryIn>},
      {"geometry_msgs/PoseStamped", append<RosPose, stampedPoseIn>},
      {"geometry_msgs/PoseWithCovarianceStamped", append<RosPose, uncertainPoseIn>},
      {"geometry_msgs/PointStamped", append<RosPose, pointIn>},
      {"geometry_msgs/TransformStamped", append<RosPose, transformIn>},
      {"tf2_msgs/TFMessage", addTransforms},
      {"apriltag_msgs/AprilTagDetectionArray", append<RosTags, tagsIn>},
      {"sensor_msgs/CameraInfo", appendCamera},
      {"vision_msgs/Detection3DArray", append<RosObjects, objectsIn>},
      {"sick_scan_xd/NAVLandmarkData", append<RosObjects, reflectorsIn>},
      {"sensor_msgs/Range", append<RosRange, rangeIn>},
      {"sensor_msgs/LaserScan", append<RosScan, scanIn>}};
  const auto found = kTakers.find(shortTypeName(type));
  return found == kTakers.end() ? nullptr : &found->second;
}
}  // namespace

void RosCollector::take(const BagMessage& message)
{
  RosTopic& topic = recording_.topics[message.topic.name];
  if (topic.messages++ == 0) topic.type = message.topic.type;
  if (topic.type != message.topic.type)
    throw DamagedBytes("of type " + message.topic.type + ", but earlier messages of the topic are " + topic.type);
  const Taker* taker = takerOf(message.topic.type);
  if (!taker) return;
  if (message.topic.encoding != "cdr")
    throw DamagedBytes("messages encoded as '" + message.topic.encoding + "', expected cdr");
  std::vector<MessageDefinition>& definitions = definitionsOf(message.topic);
  while (true)
  {
    try
    {
      (*taker)(decodeMessage(definitions.front(), message.data), message.time, topic, recording_.transforms);
      return;
    }
    catch (const DamagedBytes&)
    {
      if (definitions.size() == 1) throw;
      definitions.erase(definitions.begin());  // another version of the type
    }
  }
}

RosRecording RosCollector::finish()
{
  recording_.transforms.finish();
  return std::move(recording_);
}

std::vector<MessageDefinition>& RosCollector::definitionsOf(const BagTopic& topic)
{
  std::vector<MessageDefinition>& definitions = definitions_[topic.name];
  if (!definitions.empty()) return definitions;
  if (!topic.definition.empty())
    definitions.push_back(parseMessageDefinition(topic.type, topic.definition));
  else
    for (const std::string& text : wellKnownDefinitions(topic.type))
      definitions.push_back(parseMessageDefinition(topic.type, text));
  return definitions;
}
}  // namespace mrpt_ext
