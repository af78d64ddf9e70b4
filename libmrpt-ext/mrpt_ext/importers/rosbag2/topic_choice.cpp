#include "mrpt_ext/importers/rosbag2/topic_choice.h"

#include <algorithm>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
using Names = std::vector<std::string>;

const Names kRoles{"odometry", "truth", "detections", "scan"};

bool isPose(const RosTopic& topic) { return std::holds_alternative<std::vector<RosPose>>(topic.series); }
bool isOdometry(const RosTopic& topic) { return isPose(topic) && topic.type.ends_with("/Odometry"); }
bool isScan(const RosTopic& topic) { return std::holds_alternative<std::vector<RosScan>>(topic.series); }
bool isDetections(const RosTopic& topic)
{
  return std::holds_alternative<std::vector<RosTags>>(topic.series) ||
         std::holds_alternative<std::vector<RosObjects>>(topic.series) ||
         std::holds_alternative<std::vector<RosRange>>(topic.series);
}

bool fits(const RosTopic& topic, const std::string& role)
{
  if (role == "odometry") return isPose(topic) || topic.is_tf;
  if (role == "truth") return isPose(topic);
  return role == "scan" ? isScan(topic) : isDetections(topic);
}

bool nameHasOneOf(const std::string& name, const Names& parts)
{
  return std::any_of(parts.begin(), parts.end(),
                     [&](const std::string& part) { return name.find(part) != std::string::npos; });
}

/// What the names of independent measurements of the pose are made of.
bool saysTruth(const std::string& name)
{
  return nameHasOneOf(name, {"truth", "mocap", "motion_capture", "vicon", "optitrack", "qualisys", "vrpn", "reference",
                             "rtk"}) ||
         name.ends_with("/gt") || nameHasOneOf(name, {"/gt/", "/gt_", "_gt"});
}
/// Goals, guesses and results of other localizers.
bool saysNoTruth(const std::string& name)
{
  return nameHasOneOf(name,
                      {"goal", "initial", "amcl", "estimate", "ekf", "filter", "slam", "target", "setpoint", "cmd"});
}

class Choice
{
 public:
  Choice(const RosRecording& bag, const TopicRequests& requests, Names& notes)
      : bag_(bag), requests_(requests), notes_(notes)
  {
  }

  TopicChoice make()
  {
    for (const auto& [role, names] : requests_) check(role, names);
    TopicChoice choice;
    choice.truth = requests_.count("truth") > 0 ? requested("truth") : likelyTruth();
    choice.odometry = requests_.count("odometry") > 0 ? requested("odometry") : likelyOdometry(choice.truth);
    for (const auto& [name, topic] : bag_.topics)
    {
      const std::string role = isScan(topic) ? "scan" : isDetections(topic) ? "detections" : "";
      const auto wanted = requests_.find(role);
      if (!role.empty() && (wanted == requests_.end() || contains(wanted->second, name)))
        choice.sensors.push_back(name);
    }
    tell(choice);
    return choice;
  }

 private:
  static bool contains(const Names& names, const std::string& name)
  {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  void check(const std::string& role, const Names& names) const
  {
    for (const std::string& name : names)
    {
      if (name == "none") continue;
      const auto topic = bag_.topics.find(name);
      std::string known;
      for (const auto& [other, content] : bag_.topics)
        if (fits(content, role)) known += ' ' + other;
      if (topic == bag_.topics.end() || !fits(topic->second, role))
        throw configurationError("--topic " + role + "=" + name + ": " +
                                 (topic == bag_.topics.end() ? "not in the bag" : "of type " + topic->second.type) +
                                 ", expected" +
                                 (known.empty() ? " none, the bag has no topic for this role" : " one of" + known));
    }
  }

  std::string requested(const std::string& role) const
  {
    const std::string& name = requests_.at(role).back();
    return name == "none" ? "" : name;
  }

  std::string likelyTruth() const
  {
    Names named, possible;
    for (const auto& [name, topic] : bag_.topics)
    {
      if (!isPose(topic) || saysNoTruth(name)) continue;
      if (saysTruth(name)) named.push_back(name);
      if (!isOdometry(topic)) possible.push_back(name);
    }
    if (!named.empty()) return named.front();
    return possible.size() == 1 ? possible.front() : "";
  }

  std::string likelyOdometry(const std::string& truth) const
  {
    Names possible;
    for (const auto& [name, topic] : bag_.topics)
      if (isOdometry(topic) && name != truth && !saysTruth(name)) possible.push_back(name);
    // Fused odometry knows more than its sources; but a filter of the pose may jump, so that wheels go first.
    const auto plain =
        std::find_if(possible.begin(), possible.end(), [](const std::string& name) { return !saysNoTruth(name); });
    if (plain != possible.end()) return *plain;
    if (!possible.empty()) return possible.front();
    const auto tf = bag_.topics.find("/tf");
    return tf != bag_.topics.end() && tf->second.is_tf ? tf->first : "";
  }

  void tell(const TopicChoice& choice)
  {
    for (const auto& [name, topic] : bag_.topics)
    {
      const std::string what = name + " (" + topic.type + ", " + std::to_string(topic.messages) + " messages): ";
      if (name == choice.odometry)
        notes_.push_back(what + "odometry");
      else if (name == choice.truth)
        notes_.push_back(what + "ground truth");
      else if (contains(choice.sensors, name))
        notes_.push_back(what + "detections");
      else if (topic.is_tf)
        notes_.push_back(what + "where sensors sit on the robot");
      else if (std::holds_alternative<std::vector<RosCamera>>(topic.series))
        notes_.push_back(what + "camera model");
      else
        notes_.push_back(what + "ignored, " + whyIgnored(topic));
    }
  }

  static std::string whyIgnored(const RosTopic& topic)
  {
    if (topic.series.index() == 0) return "not about landmarks or motion";
    if (isPose(topic)) return "a pose that is not asked for (--topic truth=NAME or odometry=NAME takes it)";
    return "other topics are asked for";
  }

  const RosRecording& bag_;
  const TopicRequests& requests_;
  Names& notes_;
};
}  // namespace

void addTopicRequest(TopicRequests& requests, const std::string& text)
{
  const std::size_t equals = text.find('=');
  const std::string role = text.substr(0, equals);
  if (equals == std::string::npos || equals + 1 == text.size() ||
      std::find(kRoles.begin(), kRoles.end(), role) == kRoles.end())
    throw configurationError("--topic " + text +
                             ": expected ROLE=NAME with one of the roles odometry, truth, detections, scan");
  requests[role].push_back(text.substr(equals + 1));
}

TopicChoice chooseTopics(const RosRecording& bag, const TopicRequests& requests, Names& notes)
{
  return Choice(bag, requests, notes).make();
}
}  // namespace mrpt_ext
