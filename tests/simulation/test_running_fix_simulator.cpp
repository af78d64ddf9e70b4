#include "mrpt_ext/simulation/running_fix_simulator.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_running_fix_simulator
{
namespace
{
SimulatedSensor watcher()
{
  SimulatedSensor sensor;
  sensor.label = "stereo";
  sensor.kind = SensorKind::running_fix;
  sensor.field_of_view = degToRad(60);
  sensor.horizontal_range = true;
  sensor.fix_distance = 0.5;
  sensor.std_bearing = 0;
  return sensor;
}

std::vector<RunningFixReading> fixesAlong(const RobotPath& path, const SimulatedSensor& sensor,
                                          const std::vector<SceneFeature>& features)
{
  RandomStream random(1);
  const OdometryNoise noise{.std_xy_per_m = 0.01, .std_phi_deg_per_deg = 0, .std_phi_deg_per_m = 0};
  const SimulatedOdometry odometry(path, noise, path.duration(), random);
  RunningFixSimulator simulator(sensor, path, odometry, RandomStream(2));
  std::vector<RunningFixReading> fixes;
  for (double t = 0; t <= path.duration(); t += 0.1)
    if (const auto fix = simulator.measure(t, path.poseAt(t), features)) fixes.push_back(*fix);
  return fixes;
}

const std::vector<SceneFeature>& corners()
{
  static const std::vector<SceneFeature> features{{1, "", {5, 1, 0}, true}, {2, "", {6, -1, 0}, true}};
  return features;
}
}  // namespace

TEST(RunningFixSimulator, BothRangesBelongToTheSameLandmarkAndFitTheTruth)
{
  const RobotPath path({0, 0, 0}, {{8, 0.4, 0}});
  const auto fixes = fixesAlong(path, watcher(), corners());
  ASSERT_GE(fixes.size(), 4U);
  for (const RunningFixReading& fix : fixes)
  {
    const Vector2d landmark = corners()[static_cast<std::size_t>(fix.id - 1)].position.head<2>();
    EXPECT_NEAR(fix.first_range, (landmark - path.poseAt(fix.first_time).position()).norm(), 1e-6);
    EXPECT_NEAR(fix.second_range, (landmark - path.poseAt(fix.time).position()).norm(), 1e-6);
    EXPECT_NEAR(fix.displacement.x, 0.4 * (fix.time - fix.first_time), 0.05);
    EXPECT_GE(fix.displacement.x, 0.45);
    EXPECT_NEAR(fix.displacement_covariance(0, 0), square(0.01) * 0.4 * (fix.time - fix.first_time), 2e-9);
  }
}

TEST(RunningFixSimulator, NoRangeIsUsedTwice)
{
  const auto fixes = fixesAlong(RobotPath({0, 0, 0}, {{8, 0.4, 0}}), watcher(), corners());
  for (std::size_t i = 1; i < fixes.size(); ++i) EXPECT_GT(fixes[i].first_time, fixes[i - 1].time);
}

TEST(RunningFixSimulator, StartsOverWhenItsLandmarkIsOutOfView)
{
  const std::vector<SceneFeature> aside{{1, "", {1, 0.4, 0}, true}};  // 60 degrees: lost after 0.31 m
  EXPECT_TRUE(fixesAlong(RobotPath({0, 0, 0}, {{8, 0.4, 0}}), watcher(), aside).empty());
}

TEST(RunningFixSimulator, StandingStillGivesNoFix)
{
  EXPECT_TRUE(fixesAlong(RobotPath({0, 0, 0}, {{8, 0, 0}}), watcher(), corners()).empty());
}

TEST(RunningFixSimulator, SecondBearingOnlyOnRequest)
{
  const RobotPath path({0, 0, 0}, {{8, 0.4, 0}});
  EXPECT_FALSE(fixesAlong(path, watcher(), corners()).front().second_bearing);
  SimulatedSensor sensor = watcher();
  sensor.fix_bearing = true;
  sensor.std_bearing = 0.01;
  const auto fix = fixesAlong(path, sensor, corners()).front();
  EXPECT_TRUE(fix.second_bearing);
  EXPECT_EQ(fix.second_bearing_std, 0.01);
}
}  // namespace mrpt_ext::test_running_fix_simulator
