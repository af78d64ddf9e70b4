#include "mrpt_ext/hypotheses/propose_from_window.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "window_of_readings.h"

namespace mrpt_ext::test_propose_from_window
{
namespace
{
const LandmarkTable kMap = fiveLandmarks();
const Pose2 kRobot{2.5, 2, 0.7};
const Pose2 kStraight{0.3, 0, 0}, kBend{0.3, 0, 0.3};
const ExactSensor kBearings{.T_robot_sensor = {0.2, -0.1, 0.9}};
const ExactSensor kRanges{.bearing = false, .range = true, .T_robot_sensor = {0.2, -0.1, 0.9}};
constexpr std::size_t kRing = 36;

HypothesisSet proposed(const std::vector<Reading>& readings, const std::optional<CompassRecord>& compass = {})
{
  return proposeFromWindowLandmarks(readings, kMap, compass, kRing);
}

/// Distance from the robot to the nearest of the hypotheses.
double nearest(const HypothesisSet& hypotheses)
{
  double least = 1e9;
  for (const PoseHypothesis& h : hypotheses)
    least = std::min(least, distance(h.pose.mean, kRobot) + turned(h.pose.mean, kRobot));
  return least;
}

CompassRecord north() { return {.heading = kRobot.phi, .std_heading = 0.02}; }
}  // namespace

TEST(ProposeFromWindow, OneLandmarkByBearingsAloneIsARing)
{
  const HypothesisSet ring = proposed(windowOfReadings(kRobot, kStraight, 6, kMap, {3}, kBearings));
  ASSERT_EQ(ring.size(), kRing);
  const Vector2d landmark = kMap[3].position.head<2>();
  const double radius = (landmark - kRobot.position()).norm();
  for (const PoseHypothesis& h : ring)
  {
    EXPECT_NEAR((h.pose.mean.position() - landmark).norm(), radius, 0.01);
    EXPECT_EQ(h.source, "window_ring");
  }
  EXPECT_LT(nearest(ring), radius * kPi / kRing + kPi / kRing + 0.02) << "the truth lies between two of its poses";
}

TEST(ProposeFromWindow, ACompassClosesTheRing)
{
  const HypothesisSet found = proposed(windowOfReadings(kRobot, kStraight, 6, kMap, {3}, kBearings), north());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(nearest(found), 1e-4);
}

TEST(ProposeFromWindow, OneLandmarkByRangesAloneIsTwoRingsOnAStraightLineAndOneOnABend)
{
  const auto straight = windowOfReadings(kRobot, kStraight, 6, kMap, {3}, kRanges);
  EXPECT_EQ(proposed(straight).size(), 2 * kRing);
  const HypothesisSet two = proposed(straight, north());
  ASSERT_EQ(two.size(), 2u);
  EXPECT_LT(nearest(two), 1e-4);
  const HypothesisSet one = proposed(windowOfReadings(kRobot, kBend, 6, kMap, {3}, kRanges), north());
  ASSERT_EQ(one.size(), 1u) << "ranges to a single landmark suffice";
  EXPECT_LT(nearest(one), 1e-4);
}

TEST(ProposeFromWindow, TwoLandmarksNeedNoCompass)
{
  const HypothesisSet bearings = proposed(windowOfReadings(kRobot, kStraight, 6, kMap, {1, 3}, kBearings));
  ASSERT_EQ(bearings.size(), 1u);
  EXPECT_LT(nearest(bearings), 1e-4);
  EXPECT_EQ(bearings.front().source, "window_landmarks");
  const HypothesisSet ranges = proposed(windowOfReadings(kRobot, kStraight, 6, kMap, {1, 3}, kRanges));
  EXPECT_GE(ranges.size(), 2u) << "on a straight line the mirror image fits as well";
  EXPECT_LE(ranges.size(), 4u);
  EXPECT_LT(nearest(ranges), 1e-4);
}

TEST(ProposeFromWindow, NothingIfNoLandmarkCanBeLocalized)
{
  EXPECT_TRUE(proposed({}).empty());
  EXPECT_TRUE(proposed({seenFrom(kRobot, kMap, {3}, kBearings)}).empty());
  ExactSensor anonymous = kBearings;
  anonymous.identified = false;
  EXPECT_TRUE(proposed(windowOfReadings(kRobot, kStraight, 6, kMap, {1, 3}, anonymous)).empty());
}

TEST(ProposeFromWindow, RefinementRejectsOutliers)
{
  std::vector<Reading> readings = windowOfReadings(kRobot, kBend, 6, kMap, {0, 1, 2, 3}, kBearings);
  *readings[3].detections[1].bearing += 0.6;
  const auto pose = refineOnWindow(readings, kMap, {kRobot.x + 0.05, kRobot.y - 0.05, kRobot.phi + 0.02});
  ASSERT_TRUE(pose);
  EXPECT_LT(distance(pose->mean, kRobot) + turned(pose->mean, kRobot), 1e-4);
  EXPECT_FALSE(refineOnWindow(windowOfReadings(kRobot, kBend, 6, kMap, {0}, kBearings), kMap, kRobot)) << "a ring";
}
}  // namespace mrpt_ext::test_propose_from_window
