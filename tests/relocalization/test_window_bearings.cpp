#include "mrpt_ext/relocalization/window_bearings.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext
{
namespace
{
const Vector2d kPost(5, 1);
constexpr double kStd = degToRad(1.0);

/// Half a metre ahead and a turn per step; every look sees the post, from 0.1 m before the robot's middle.
std::vector<TrajectoryStep> way(std::size_t steps, double std_turn)
{
  std::vector<TrajectoryStep> travel(steps);
  Pose2 robot{0, 0, 0};
  const Pose2 T_robot_sensor{0.1, 0, 0.2};
  for (std::size_t k = 0; k < steps; ++k)
  {
    if (k > 0) travel[k].increment = {0.5, 0, 0.1};
    robot = compose(robot, travel[k].increment);
    travel[k].noise(2, 2) = square(std_turn);
    AnonymousDetection post{.std_bearing = kStd};
    post.bearing = predictBearing(robot, kPost, T_robot_sensor);
    travel[k].seen.push_back({T_robot_sensor, {}, {post}});
  }
  return travel;
}
}  // namespace

TEST(JoinedBearings, AllPointAtWhatTheyShowFromTheOnePose)
{
  const Pose2 third = compose(compose({0, 0, 0}, {0.5, 0, 0.1}), {0.5, 0, 0.1});
  const auto joined = windowBearings(way(5, 0), 2);
  ASSERT_EQ(joined.size(), 5U);
  for (const WindowBearing& bearing : joined)
    EXPECT_NEAR(wrap(bearing.bearing - predictBearing(third, kPost, bearing.T_robot_sensor)), 0, 1e-12);
}

TEST(JoinedBearings, TheirDeviationsGrowWithTheWayBetween)
{
  const auto joined = windowBearings(way(4, degToRad(1)), 0);
  ASSERT_EQ(joined.size(), 4U);
  EXPECT_GE(joined.front().std_bearing, kStd);
  for (std::size_t k = 1; k < joined.size(); ++k) EXPECT_GT(joined[k].std_bearing, joined[k - 1].std_bearing);
  EXPECT_GT(joined.back().std_bearing, degToRad(2));
}

TEST(JoinedBearings, WhatOdometryDoesNotJoinIsLeftOut)
{
  EXPECT_EQ(windowBearings(way(9, degToRad(2)), 4).size(), 5U);  // two steps either way are 2.8 deg, three 3.5
  EXPECT_EQ(windowBearings(way(9, degToRad(10)), 4).size(), 1U);
}

TEST(JoinedBearings, TheyAreNotMoreThanASearchNeeds) { EXPECT_LE(windowBearings(way(100, 0), 50).size(), 21U); }

TEST(JoinedBearings, BlindLooksAndUnknownKindsGiveNothing)
{
  std::vector<TrajectoryStep> blind(3);
  EXPECT_TRUE(windowBearings(blind, 1).empty());
  std::vector<TrajectoryStep> strange = way(3, 0);
  for (TrajectoryStep& step : strange) step.seen.front().detections.front().kind = kUnknownCategory;
  EXPECT_TRUE(windowBearings(strange, 1).empty());
}
}  // namespace mrpt_ext
