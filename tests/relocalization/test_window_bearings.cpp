#include "mrpt_ext/relocalization/window_bearings.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext::test_window_bearings
{
namespace
{
const Vector2d kPost(5, 1);
constexpr double kStd = degToRad(1.0);

/// 0.5 m and 0.1 rad per step; every scan contains the post, from a sensor 0.1 m before the robot's centre.
std::vector<TrajectoryStep> trajectory(std::size_t steps, double std_turn)
{
  std::vector<TrajectoryStep> result(steps);
  Pose2 robot{0, 0, 0};
  const Pose2 T_robot_sensor{0.1, 0, 0.2};
  for (std::size_t k = 0; k < steps; ++k)
  {
    if (k > 0) result[k].increment = {0.5, 0, 0.1};
    robot = compose(robot, result[k].increment);
    result[k].noise(2, 2) = square(std_turn);
    AnonymousDetection post{.std_bearing = kStd};
    post.bearing = predictBearing(robot, kPost, T_robot_sensor);
    result[k].scans.push_back({T_robot_sensor, {}, {post}});
  }
  return result;
}
}  // namespace

TEST(WindowBearings, AllPointAtTheirLandmarkFromTheCentralPose)
{
  const Pose2 third = compose(compose({0, 0, 0}, {0.5, 0, 0.1}), {0.5, 0, 0.1});
  const auto bearings = windowBearings(trajectory(5, 0), 2);
  ASSERT_EQ(bearings.size(), 5U);
  for (const WindowBearing& bearing : bearings)
    EXPECT_NEAR(wrap(bearing.bearing - predictBearing(third, kPost, bearing.T_robot_sensor)), 0, 1e-12);
}

TEST(WindowBearings, StandardDeviationsGrowWithTheDistance)
{
  const auto bearings = windowBearings(trajectory(4, degToRad(1)), 0);
  ASSERT_EQ(bearings.size(), 4U);
  EXPECT_GE(bearings.front().std_bearing, kStd);
  for (std::size_t k = 1; k < bearings.size(); ++k) EXPECT_GT(bearings[k].std_bearing, bearings[k - 1].std_bearing);
  EXPECT_GT(bearings.back().std_bearing, degToRad(2));
}

TEST(WindowBearings, StepsWithInaccurateOdometryAreLeftOut)
{
  EXPECT_EQ(windowBearings(trajectory(9, degToRad(2)), 4).size(), 5U);  // two steps either way are 2.8 deg, three 3.5
  EXPECT_EQ(windowBearings(trajectory(9, degToRad(10)), 4).size(), 1U);
}

TEST(WindowBearings, AreLimitedInNumber) { EXPECT_LE(windowBearings(trajectory(100, 0), 50).size(), 21U); }

TEST(WindowBearings, EmptyStepsAndUnknownCategoriesGiveNothing)
{
  std::vector<TrajectoryStep> blind(3);
  EXPECT_TRUE(windowBearings(blind, 1).empty());
  std::vector<TrajectoryStep> unknown = trajectory(3, 0);
  for (TrajectoryStep& step : unknown) step.scans.front().detections.front().category = kUnknownCategory;
  EXPECT_TRUE(windowBearings(unknown, 1).empty());
}
}  // namespace mrpt_ext::test_window_bearings
