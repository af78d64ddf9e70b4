#include "mrpt_ext/importers/rosbag2/topic_choice.h"

#include <gtest/gtest.h>

#include "sample_data.h"

namespace mrpt_ext::test_topic_choice
{
namespace
{
RosTopic poses(const std::string& type) { return {.type = type, .messages = 1, .series = std::vector<RosPose>(1)}; }

RosRecording bagWith(const std::map<std::string, RosTopic>& topics)
{
  return {.topics = topics, .transforms = {}, .notes = {}};
}

TopicChoice chosen(const RosRecording& bag, const std::vector<std::string>& requests = {})
{
  TopicRequests roles;
  for (const std::string& request : requests) addTopicRequest(roles, request);
  std::vector<std::string> notes;
  return chooseTopics(bag, roles, notes);
}

const std::string kOdometry = "nav_msgs/msg/Odometry", kPose = "geometry_msgs/msg/PoseStamped";
}  // namespace

TEST(TopicChoice, NamesTellTruthFromOdometry)
{
  const RosRecording bag = bagWith({{"/ground_truth/odom", poses(kOdometry)},
                                    {"/odometry/filtered", poses(kOdometry)},
                                    {"/wheel/odom", poses(kOdometry)},
                                    {"/goal_pose", poses(kPose)}});
  EXPECT_EQ(chosen(bag).odometry, "/wheel/odom");
  EXPECT_EQ(chosen(bag).truth, "/ground_truth/odom");
}

TEST(TopicChoice, OnePoseThatIsNoGoalIsTheTruth)
{
  EXPECT_EQ(chosen(bagWith({{"/goal_pose", poses(kPose)}, {"/robot/pose", poses(kPose)}})).truth, "/robot/pose");
  EXPECT_EQ(chosen(bagWith({{"/a/pose", poses(kPose)}, {"/b/pose", poses(kPose)}})).truth, "");
  EXPECT_EQ(chosen(bagWith({{"/amcl_pose", poses(kPose)}})).truth, "");
}

TEST(TopicChoice, RequestsWin)
{
  RosRecording bag = bagWith({{"/odom", poses(kOdometry)}, {"/a/pose", poses(kPose)}, {"/b/pose", poses(kPose)}});
  bag.topics["/front"] =
      bag.topics["/rear"] = {.type = "sensor_msgs/msg/LaserScan", .messages = 1, .series = std::vector<RosScan>(1)};
  const TopicChoice choice = chosen(bag, {"truth=/b/pose", "odometry=none", "scan=/rear"});
  EXPECT_EQ(choice.truth, "/b/pose");
  EXPECT_EQ(choice.odometry, "");
  EXPECT_EQ(choice.sensors, std::vector<std::string>{"/rear"});
  EXPECT_EQ(chosen(bag).sensors.size(), 2U);
}

TEST(TopicChoice, MistakesAreALine)
{
  const RosRecording bag = bagWith({{"/odom", poses(kOdometry)}});
  EXPECT_INPUT_ERROR(chosen(bag, {"speed=/odom"}), "expected ROLE=NAME");
  EXPECT_INPUT_ERROR(chosen(bag, {"odometry"}), "expected ROLE=NAME");
  EXPECT_INPUT_ERROR(chosen(bag, {"truth=/pose"}), "--topic truth=/pose: not in the bag, expected one of /odom");
  EXPECT_INPUT_ERROR(chosen(bag, {"scan=/odom"}), "of type nav_msgs/msg/Odometry, expected none");
}
}  // namespace mrpt_ext::test_topic_choice
