#include "mrpt_ext/experiment/log_adaptation.h"

#include <gtest/gtest.h>

#include <utility>

namespace mrpt_ext::test_log_adaptation
{
namespace
{
constexpr double kDuration = 10;  // [s]

/// What a log of a hundred frames with one detection each contains.
AvailableMeasurements logWith(const Detection& detection, const Pose2& T_robot_sensor)
{
  Reading reading;
  reading.T_robot_sensor = T_robot_sensor;
  reading.detections = {detection};
  Frame frame;
  frame.readings = {reading};
  AvailableMeasurements available;
  for (int k = 0; k < 100; ++k) available.add(frame);
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
  adaptToLog(config, {available, {}, {}, kDuration}, notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(config.filter.motion.type, MotionType::odometry);
  EXPECT_TRUE(config.filter.heading_observable);
}

TEST(LogAdaptation, AnAssumedBoxIsAsLargeAsTheDetectionsReach)
{
  AvailableMeasurements available;
  available.odometry = true;
  Reading reading;
  reading.detections = {{.id = 1, .range = 10, .std_range = 0.1}};
  DetectionReach reach;
  reach.add({.readings = {reading}},
            LandmarkTable({{.id = 1, .position = {0, 0, 0}}, {.id = 2, .position = {6, 1, 0}}}));
  for (const bool assumed : {true, false})
  {
    LocalizationConfig config;
    config.region_assumed = assumed;
    config.filter.region = {.low = {-3, -3}, .high = {9, 4}};
    std::vector<std::string> notes;
    adaptToLog(config, {available, reach, {}, kDuration}, notes);
    const double margin = assumed ? 10 : 3;
    EXPECT_EQ(config.filter.region.low, Vector2d(-margin, -margin));
    EXPECT_EQ(config.filter.region.high, Vector2d(6 + margin, 1 + margin));
    EXPECT_EQ(notes.size(), assumed ? 1U : 0U);
    if (!assumed) continue;
    EXPECT_EQ(config.running_fix.region.low, config.filter.region.low);
    EXPECT_NE(notes.front().find("init_PDF_margin_m"), std::string::npos);
  }
}

TEST(LogAdaptation, ASensorOfAnonymousBearingsSeesAsFarToTheSideAsItsBearings)
{
  for (const auto& [id, calibrates] : {std::pair(int{kNoId}, true), std::pair(1, true), std::pair(int{kNoId}, false)})
  {
    const bool adapts = id == kNoId && calibrates;
    Reading reading{.sensor = "camera.4"};
    reading.detections = {{.id = id, .bearing = -0.5, .std_bearing = 0.01}};
    AvailableMeasurements available;
    available.odometry = true;
    BearingExtent extent;
    for (int k = 0; k < 100; ++k)
    {
      available.add({.readings = {reading}});
      extent.add({.readings = {reading}});
    }
    LocalizationConfig config;
    config.auto_calibrate = calibrates;
    config.frames.sensors["camera"].clutter_probability = 0.1;
    std::vector<std::string> notes;
    adaptToLog(config, {available, {}, extent, kDuration}, notes);
    const SensorConfig& sensor = configOf(config.frames.sensors, "camera.4");
    EXPECT_EQ(sensor.clutter_probability, 0.1);
    EXPECT_EQ(sensor.field_of_view.has_value(), adapts);
    EXPECT_EQ(notes.size(), adapts ? 1U : 0U);
    if (!adapts) continue;
    EXPECT_NEAR(*sensor.field_of_view, 2 * (0.5 + degToRad(2.0)), 1e-12);
    EXPECT_NE(notes.front().find("[Sensor_camera.4] field_of_view_deg"), std::string::npos);
  }
}

TEST(LogAdaptation, WithoutOdometryTheMotionIsARandomWalkAndTheUserIsTold)
{
  LocalizationConfig config;
  std::vector<std::string> notes;
  adaptToLog(config, {logWith(kBearing, {}), {}, {}, kDuration}, notes);
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
  adaptToLog(config, {logWith(kBearing, {}), {}, {}, kDuration}, notes);
  EXPECT_EQ(config.filter.motion.std_xy_per_s, 0.1);
  EXPECT_TRUE(notes.empty());
}

TEST(LogAdaptation, TheStationaryDeviationBalancesWalkAndInformation)
{
  // p' = walk - information p^2 = 0
  const double p = square(stationaryStd(0.01, 4));
  EXPECT_NEAR(0.01 - 4 * square(p), 0, 1e-15);
  EXPECT_TRUE(std::isinf(stationaryStd(0.01, 0)));
}

TEST(LogAdaptation, RangesToTheOriginAloneDoNotTellTheHeading)
{
  for (const Pose2& T_robot_sensor : {Pose2{}, Pose2{0.05, 0, 0}, Pose2{0.5, 0, 0}})
  {
    LocalizationConfig config;
    std::vector<std::string> notes;
    adaptToLog(config, {logWith(kRange, T_robot_sensor), {}, {}, kDuration}, notes);
    const bool lever_arm = T_robot_sensor.x > 0.1;
    EXPECT_EQ(config.filter.heading_observable, lever_arm) << T_robot_sensor.x;
    EXPECT_EQ(std::isinf(config.filter.verdict.max_std_phi), !lever_arm) << T_robot_sensor.x;
    EXPECT_EQ(notes.size(), lever_arm ? 1U : 2U);
  }
}
}  // namespace mrpt_ext::test_log_adaptation
