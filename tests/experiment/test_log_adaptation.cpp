#include "mrpt_ext/experiment/log_adaptation.h"

#include <gtest/gtest.h>

namespace mrpt_ext
{
namespace
{
/// What a log of one frame with one detection contains.
AvailableMeasurements logWith(const Detection& detection, const Pose2& T_robot_sensor)
{
  Reading reading;
  reading.T_robot_sensor = T_robot_sensor;
  reading.detections = {detection};
  Frame frame;
  frame.readings = {reading};
  AvailableMeasurements available;
  available.add(frame);
  return available;
}

const Detection kRange{.id = 1, .range = 3, .std_range = 0.1};
const Detection kBearing{.id = 1, .bearing = 0.3, .std_bearing = 0.01};
}  // namespace

TEST(LogAdaptation, ALogWithOdometryIsTakenAsConfigured)
{
  AvailableMeasurements available = logWith(kRange, {});
  available.odometry = true;
  LocalizationConfig config;
  std::vector<std::string> notes;
  adaptToLog(config, available, notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(config.filter.motion.type, MotionType::odometry);
  EXPECT_TRUE(config.filter.heading_observable);
}

TEST(LogAdaptation, WithoutOdometryTheMotionIsARandomWalkAndTheUserIsTold)
{
  LocalizationConfig config;
  std::vector<std::string> notes;
  adaptToLog(config, logWith(kBearing, {}), notes);
  EXPECT_EQ(config.filter.motion.type, MotionType::random_walk);
  EXPECT_GT(config.filter.motion.std_xy_per_s, 0.1);
  EXPECT_TRUE(config.filter.heading_observable);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes.front().find("no odometry"), std::string::npos);
}

TEST(LogAdaptation, AConfiguredRandomWalkIsKept)
{
  LocalizationConfig config;
  config.filter.motion.type = MotionType::random_walk;
  config.filter.motion.std_xy_per_s = 0.1;
  std::vector<std::string> notes;
  adaptToLog(config, logWith(kBearing, {}), notes);
  EXPECT_EQ(config.filter.motion.std_xy_per_s, 0.1);
  EXPECT_TRUE(notes.empty());
}

TEST(LogAdaptation, RangesToTheOriginAloneDoNotTellTheHeading)
{
  for (const Pose2& T_robot_sensor : {Pose2{}, Pose2{0.05, 0, 0}, Pose2{0.5, 0, 0}})
  {
    LocalizationConfig config;
    std::vector<std::string> notes;
    adaptToLog(config, logWith(kRange, T_robot_sensor), notes);
    const bool lever_arm = T_robot_sensor.x > kRange.std_range;
    EXPECT_EQ(config.filter.heading_observable, lever_arm) << T_robot_sensor.x;
    EXPECT_EQ(std::isinf(config.filter.verdict.max_std_phi), !lever_arm) << T_robot_sensor.x;
    EXPECT_EQ(notes.size(), lever_arm ? 1U : 2U);
  }
}
}  // namespace mrpt_ext
