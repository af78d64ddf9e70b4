#include "mrpt_ext/importers/rosbag2/rosbag2_recording.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "mrpt_ext/files/landmark_map_file.h"
#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/recording_notes.h"
#include "mrpt_ext/importers/rosbag2/bag_files.h"
#include "mrpt_ext/importers/rosbag2/sensor_records.h"
#include "mrpt_ext/importers/truth_heading.h"

namespace mrpt_ext
{
namespace
{
const RosSensorNoise kNoise;
constexpr double kLargestTilt = 5;  ///< [deg] of a scanner's plane before it is told

/// "camera_detections" of "/camera/detections".
std::string labelOf(const std::string& topic)
{
  std::string label =
      topic.substr(topic.find_first_not_of('/') == std::string::npos ? 0 : topic.find_first_not_of('/'));
  std::replace(label.begin(), label.end(), '/', '_');
  return label;
}

/// Factor that makes whole numbers of intensities between 0 and 1, as logs keep them; else 1.
float intensityFactor(const std::vector<RosScan>& series)
{
  float brightest = 0;
  for (const RosScan& scan : series)
    for (const float intensity : scan.intensities) brightest = std::max(brightest, intensity);
  return brightest > 0 && brightest <= 1 ? 1000.0F : 1.0F;
}

/// The records of the chosen topics, in the axes of the robot.
class RecordingBuilder
{
 public:
  RecordingBuilder(RosRecording bag, const TopicChoice& choice, std::string base)
      : bag_(std::move(bag)), choice_(choice), base_(std::move(base))
  {
  }

  Recording build()
  {
    if (base_.empty()) base_ = likelyBase();
    note("the robot's frame is '" + base_ + "'");
    addOdometry();
    for (const std::string& topic : choice_.sensors) addSensor(topic);
    addTruth();
    sortByTime(recording_);
    correctTruthHeading(recording_);
    return std::move(recording_);
  }

 private:
  void note(const std::string& text)
  {
    if (told_.insert(text).second) recording_.notes.push_back(text);
  }

  [[nodiscard]] const RosTopic& topic(const std::string& name) const { return bag_.topics.at(name); }

  /// The moving transform from the frame of odometry to the robot (of /tf); nothing without one.
  [[nodiscard]] std::optional<TransformTree::Edge> odometryEdge() const
  {
    std::vector<TransformTree::Edge> possible;
    for (const auto& edge : bag_.transforms.movingEdges())
      if (base_.empty() || bag_.transforms.fixedPose(edge.second, base_)) possible.push_back(edge);
    const auto named = std::find_if(possible.begin(), possible.end(),
                                    [](const auto& edge) { return edge.first.find("odom") != std::string::npos; });
    if (named != possible.end()) return *named;
    return std::nullopt;
  }

  [[nodiscard]] std::string likelyBase() const
  {
    if (!choice_.odometry.empty())
    {
      if (const auto* poses = std::get_if<std::vector<RosPose>>(&topic(choice_.odometry).series))
        for (const RosPose& pose : *poses)
          if (!pose.child_frame.empty()) return pose.child_frame;
      if (const auto edge = odometryEdge(); edge && topic(choice_.odometry).is_tf) return edge->second;
    }
    for (const char* name : {"base_link", "base_footprint"})
      if (bag_.transforms.has(name)) return name;
    return "base_link";
  }

  /// Pose of a frame on the robot; where no transform tells it, `otherwise`.
  Pose3 poseOnRobot(const std::string& frame, const Pose3& otherwise = {})
  {
    if (frame.empty() || frame == base_) return otherwise;
    auto [known, is_new] = on_robot_.try_emplace(frame);
    if (is_new) known->second = bag_.transforms.fixedPose(base_, frame);
    if (known->second) return *known->second;
    note("warning: no fixed transform from '" + base_ + "' to '" + frame + "', it is taken for the robot's origin");
    return otherwise;
  }

  void addOdometry()
  {
    if (choice_.odometry.empty()) return note("no odometry in the bag");
    if (topic(choice_.odometry).is_tf) return addOdometryOfTransforms();
    std::size_t without_heading = 0;
    for (const RosPose& pose : std::get<std::vector<RosPose>>(topic(choice_.odometry).series))
    {
      if (!pose.has_rotation)
        ++without_heading;
      else
        recording_.records.push_back(
            OdometryRecord{pose.header.time, (pose.pose * childToRobot(pose.child_frame)).planar()});
    }
    noteCount(recording_, without_heading, "odometry messages without an orientation dropped");
  }

  void addOdometryOfTransforms()
  {
    const auto edge = odometryEdge();
    if (!edge) return note("no moving transform from a frame 'odom' to '" + base_ + "': no odometry");
    note("odometry: transforms from '" + edge->first + "' to '" + edge->second + "'");
    const Pose3 T_child_robot = childToRobot(edge->second);
    for (const auto& [time, pose] : bag_.transforms.transforms(*edge))
      recording_.records.push_back(OdometryRecord{time, (pose * T_child_robot).planar()});
  }

  /// Pose of the robot in a frame that sits on it.
  Pose3 childToRobot(const std::string& frame) { return poseOnRobot(frame).inverse(); }

  void addSensor(const std::string& name)
  {
    const std::size_t before = recording_.records.size();
    // Scans take most of the memory: they are moved, not copied.
    std::visit([&](auto& series) { addSeries(name, series); }, bag_.topics.at(name).series);
    for (std::size_t i = before; i < recording_.records.size(); ++i)
      std::visit(
          [&](auto& record)
          {
            if constexpr (requires { record.sensor; }) record.sensor = labelOf(name);
          },
          recording_.records[i]);
  }

  /// The camera of that frame, or the only one.
  [[nodiscard]] const RosCamera* cameraOf(const std::string& frame) const
  {
    std::vector<const RosCamera*> all;
    for (const auto& [name, topic] : bag_.topics)
      if (const auto* cameras = std::get_if<std::vector<RosCamera>>(&topic.series))
        for (const RosCamera& camera : *cameras)
        {
          if (camera.header.frame == frame) return &camera;
          all.push_back(&camera);
        }
    return all.size() == 1 ? all.front() : nullptr;
  }

  void addSeries(const std::string& name, const std::vector<RosTags>& series)
  {
    const Pose3 forward{Vector3d::Zero(), opticalRotation()};
    for (const RosTags& message : series)
    {
      const RosCamera* camera = cameraOf(message.header.frame);
      if (!camera) return note("warning: " + name + ": ignored, no CameraInfo of frame '" + message.header.frame + "'");
      const Pose3 pose = poseOnRobot(message.header.frame, forward);
      recording_.records.emplace_back(readingOf(message, *camera, pose, bag_.transforms, kNoise));
    }
  }

  void addSeries(const std::string& name, const std::vector<RosObjects>& series)
  {
    const bool reflectors = topic(name).type.ends_with("/NAVLandmarkData");
    for (const RosObjects& message : series)
    {
      const Pose3 pose = poseOnRobot(message.header.frame);
      recording_.records.emplace_back(reflectors ? reflectorReadingOf(message, pose, kNoise)
                                                 : readingOf(message, pose, kNoise));
    }
  }

  void addSeries(const std::string& name, const std::vector<RosRange>& series)
  {
    std::size_t silent = 0;
    for (const RosRange& message : series)
    {
      // Where the frame is not on the robot, it is that of the other radio.
      const bool on_robot = message.header.frame == base_ || bag_.transforms.has(message.header.frame);
      const auto number = on_robot ? std::nullopt : numberAtEnd(message.header.frame);
      const Pose3 pose = on_robot ? poseOnRobot(message.header.frame) : Pose3();
      Reading reading = readingOf(message, number.value_or(kNoId), pose, kNoise);
      if (reading.detections.empty())
        ++silent;
      else
        recording_.records.emplace_back(std::move(reading));
    }
    noteCount(recording_, silent, name + ": messages without a range within the sensor's limits dropped");
  }

  void addSeries(const std::string& name, std::vector<RosScan>& series)
  {
    std::size_t dark = 0;
    const float factor = intensityFactor(series);
    if (factor != 1) note(name + ": intensities of at most 1 are multiplied by 1000, logs keep whole numbers");
    for (RosScan& message : series)
    {
      if (message.intensities.empty())
      {
        ++dark;
        continue;
      }
      const Pose3 pose = poseOnRobot(message.header.frame);
      const double tilt = radToDeg(std::acos(std::min(1.0, std::abs(pose.rotation(2, 2)))));
      if (tilt > kLargestTilt)
        note("warning: " + name + ": the scanner is tilted by " + fixedText(tilt, 1) +
             " degrees, which is not corrected");
      RangeScan scan = scanRecordOf(std::move(message), pose, kNoise);
      for (float& intensity : scan.intensities) intensity *= factor;
      recording_.records.emplace_back(std::move(scan));
    }
    noteCount(recording_, dark, name + ": scans without intensities dropped, no reflector can be told in them");
  }

  template <typename Other>
  void addSeries(const std::string&, const Other&)
  {
  }

  void addTruth()
  {
    if (choice_.truth.empty()) return note("no ground truth in the bag");
    std::size_t repeated = 0;
    std::vector<RosPose> poses = std::get<std::vector<RosPose>>(topic(choice_.truth).series);
    std::stable_sort(poses.begin(), poses.end(),
                     [](const RosPose& a, const RosPose& b) { return a.header.time < b.header.time; });
    for (const RosPose& pose : poses)
    {
      if (!recording_.truth.empty() && recording_.truth.back().time == pose.header.time)
      {
        ++repeated;
        continue;
      }
      recording_.truth.push_back(truthPose(pose));
    }
    noteCount(recording_, repeated, "poses of the ground truth repeat the stamp of the one before, dropped");
  }

  /// Of the robot; without an orientation the point that is measured has to be the robot's origin.
  TimedPose truthPose(const RosPose& measured)
  {
    const bool known = measured.child_frame.empty() || measured.child_frame == base_ ||
                       bag_.transforms.fixedPose(base_, measured.child_frame).has_value();
    if (!known)
      note("the ground truth is that of '" + measured.child_frame + "', which is taken for the robot's origin");
    if (!known || !measured.has_rotation) return {measured.header.time, measured.pose.planar(), measured.has_rotation};
    return {measured.header.time, (measured.pose * childToRobot(measured.child_frame)).planar(), true};
  }

  RosRecording bag_;
  const TopicChoice& choice_;
  std::string base_;
  std::map<std::string, std::optional<Pose3>> on_robot_;  // by frame, once asked for
  Recording recording_;
  std::set<std::string> told_;
};
}  // namespace

Recording importRosbag2(const std::vector<std::filesystem::path>& inputs, const Rosbag2Options& options)
{
  RosCollector collector;
  std::vector<std::string> notes = readBag(inputs, [&](const BagMessage& message) { collector.take(message); });
  RosRecording bag = collector.finish();
  const TopicChoice choice = chooseTopics(bag, options.topics, notes);
  Recording recording = RecordingBuilder(std::move(bag), choice, options.base).build();
  recording.notes.insert(recording.notes.begin(), notes.begin(), notes.end());
  if (options.map.empty())
    recording.notes.emplace_back("warning: a bag has no map of landmarks, give it by --map FILE");
  else
    recording.map = readLandmarkMapFile(options.map);
  return recording;
}
}  // namespace mrpt_ext
