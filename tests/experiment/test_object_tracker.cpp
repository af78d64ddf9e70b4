#include "mrpt_ext/experiment/object_tracker.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext::test_object_tracker
{
namespace
{
const Vector2d kBall{3, 2};
const Pose2 kRobot{1, 0.5, 0.4};

Reading ballSeenBy(const Pose2& robot, const Pose2& mount, bool with_range, const std::string& sensor)
{
  Reading reading{.sensor = sensor, .T_robot_sensor = mount};
  Detection ball{.category = "ball", .bearing = predictBearing(robot, kBall, mount), .std_bearing = 0.01};
  if (with_range)
  {
    ball.range = predictRange(robot, kBall, mount);
    ball.std_range = 0.05;
  }
  reading.detections = {ball};
  return reading;
}

Frame frameAt(double time, std::vector<Reading> readings) { return {.time = time, .readings = std::move(readings)}; }

PoseEstimate pointAt(double time, const Pose2& pose)
{
  return {.time = time, .pose = {pose, Vector3d(0.01, 0.01, 0.001).asDiagonal()}};
}

std::vector<ObjectRow> placed(const std::vector<Frame>& sightings, const PoseEstimate& robot,
                              const OdometryPath& odometry = {{}, {}})
{
  ObjectTracker tracker(odometry);
  tracker.add(sightings);
  DiskBackedSequence<ObjectRow> rows;
  tracker.locate(robot, rows);
  return {rows.begin(), rows.end()};
}
}  // namespace

TEST(ObjectTracker, RangeAndBearingLocateTheBall)
{
  const Pose2 mount{0.3, -0.2, 0.8};
  const auto rows = placed({frameAt(2, {ballSeenBy(kRobot, mount, true, "eye")})}, pointAt(2, kRobot));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].time, 2);
  EXPECT_EQ(rows[0].label, "ball");
  EXPECT_LT((rows[0].position - kBall).norm(), 1e-9);
  EXPECT_LT((transform(kRobot, rows[0].position_robot) - kBall).norm(), 1e-9);
  EXPECT_GT(rows[0].covariance(0, 0), 0.01);  // at least the robot's own
  EXPECT_GT(rows[0].covariance(1, 1), 0.01);
}

TEST(ObjectTracker, TwoBearingsFromTwoSensorsAreTriangulated)
{
  const auto rows = placed({frameAt(2, {ballSeenBy(kRobot, {0, 0.3, 0.2}, false, "left"),
                                        ballSeenBy(kRobot, {0, -0.3, -0.2}, false, "right")})},
                           pointAt(2, kRobot));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_LT((rows[0].position - kBall).norm(), 1e-9);
}

TEST(ObjectTracker, OneBearingGivesNoPosition)
{
  EXPECT_TRUE(placed({frameAt(2, {ballSeenBy(kRobot, {}, false, "eye")})}, pointAt(2, kRobot)).empty());
  EXPECT_TRUE(
      placed({frameAt(2, {ballSeenBy(kRobot, {}, false, "a"), ballSeenBy(kRobot, {}, false, "b")})}, pointAt(2, kRobot))
          .empty());
}

TEST(ObjectTracker, CategoriesAreNotMixed)
{
  Reading cup = ballSeenBy(kRobot, {0, -0.3, 0}, false, "right");
  cup.detections[0].category = "cup";
  EXPECT_TRUE(placed({frameAt(2, {ballSeenBy(kRobot, {0, 0.3, 0}, false, "left"), cup})}, pointAt(2, kRobot)).empty());
  Reading both = ballSeenBy(kRobot, {}, true, "eye");
  both.detections.push_back(both.detections[0]);
  both.detections[1].category = "cup";
  const auto rows = placed({frameAt(2, {both})}, pointAt(2, kRobot));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].label, "ball");
  EXPECT_EQ(rows[1].label, "cup");
}

TEST(ObjectTracker, DetectionsBetweenFramesAreLocatedFromThePoseAtTheirTime)
{
  const Pose2 now = compose(kRobot, {1, 0, 0.5});
  const OdometryPath odometry({{1, {0, 0, 0}}, {2, {1, 0, 0.5}}}, {});
  const auto rows = placed({frameAt(1, {ballSeenBy(kRobot, {}, true, "eye")})}, pointAt(2, now), odometry);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].time, 1);
  EXPECT_LT((rows[0].position - kBall).norm(), 1e-9);
}

TEST(ObjectTracker, EveryDetectionIsLocatedOnceInOrder)
{
  const std::vector<Frame> sightings{frameAt(1, {ballSeenBy(kRobot, {}, true, "eye")}),
                                     frameAt(2, {ballSeenBy(kRobot, {}, true, "eye")}),
                                     frameAt(5, {ballSeenBy(kRobot, {}, true, "eye")})};
  const OdometryPath odometry({}, {});
  ObjectTracker tracker(odometry);
  tracker.add(sightings);
  DiskBackedSequence<ObjectRow> rows;
  tracker.locate(pointAt(0.5, kRobot), rows);
  EXPECT_EQ(rows.size(), 0u);
  tracker.locate(pointAt(2, kRobot), rows);
  EXPECT_EQ(rows.size(), 2u);
  tracker.locate(pointAt(3, kRobot), rows);
  EXPECT_EQ(rows.size(), 2u);
  tracker.locate(pointAt(9, kRobot), rows);
  EXPECT_EQ(rows.size(), 3u);
}
}  // namespace mrpt_ext::test_object_tracker
