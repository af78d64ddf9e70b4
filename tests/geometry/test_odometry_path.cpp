#include "mrpt_ext/geometry/odometry_path.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_odometry_path
{
namespace
{
void expectPose(const Pose2& actual, const Pose2& expected)
{
  EXPECT_NEAR(actual.x, expected.x, 1e-12);
  EXPECT_NEAR(actual.y, expected.y, 1e-12);
  EXPECT_NEAR(std::abs(wrap(actual.phi - expected.phi)), 0, 1e-12);
}

/// Ahead, a turn on the spot across the seam of the heading, ahead again.
const std::vector<OdometryRecord> kRecords{{10, {0, 0, 3}}, {12, {2, 0, 3}}, {13, {2, 0, -3}}, {15, {2, 4, -3}}};

// In its own frame the robot drives up the y axis, heading pi/2, 2 m in 2 s.
const Trajectory kUpwards{{0, {5, 5, kPi / 2}, true}, {2, {5, 7, kPi / 2}, true}};

PoseEstimate estimateAt(double time, const Pose2& pose)
{
  PoseEstimate point;
  point.time = time;
  point.pose.mean = pose;
  return point;
}
}  // namespace

TEST(OdometryPath, InterpolatesBetweenRecordsAndAcrossTheSeam)
{
  const OdometryPath path(kRecords, {});
  expectPose(path.at(10), {0, 0, 3});
  expectPose(path.at(11), {1, 0, 3});
  expectPose(path.at(12.5), {2, 0, kPi});
  expectPose(path.at(13.5), {2, 1, -3});
  EXPECT_EQ(path.trajectory().size(), 4u);
}

TEST(OdometryPath, ForgettingTheOldChangesNothingLater)
{
  OdometryPath whole, recent;
  for (int k = 0; k < 5000; ++k)
  {
    const OdometryRecord record{0.1 * k, {0.05 * k, std::sin(0.01 * k), 0.02 * k}};
    whole.add(record);
    recent.add(record);
    if (k > 10) recent.forgetBefore(0.1 * k - 0.95);
  }
  EXPECT_LT(recent.trajectory().size(), 1100u);
  const OdometryMotion a = whole.between(499.02, 499.67), b = recent.between(499.02, 499.67);
  EXPECT_EQ(a.increment.x, b.increment.x);
  EXPECT_EQ(a.increment.phi, b.increment.phi);
  EXPECT_EQ(a.path_length, b.path_length);
  EXPECT_EQ(a.turned, b.turned);
}

TEST(OdometryPath, StandsStillBeforeTheFirstAndAfterTheLast)
{
  const OdometryPath path(kRecords, {});
  expectPose(path.at(0), {0, 0, 3});
  expectPose(path.at(99), {2, 4, -3});
  const OdometryMotion late = path.between(15, 20);
  expectPose(late.increment, {});
  EXPECT_EQ(late.path_length, 0);
  EXPECT_EQ(late.duration, 5);
}

TEST(OdometryPath, MotionsAddUpDistanceRotationAndTime)
{
  const OdometryPath path(kRecords, {});
  const OdometryMotion all = path.between(10, 15);
  expectPose(all.increment, between({0, 0, 3}, {2, 4, -3}));
  EXPECT_NEAR(all.path_length, 6, 1e-12);
  EXPECT_NEAR(all.turned, kTwoPi - 6, 1e-12);
  EXPECT_EQ(all.duration, 5);
  const OdometryMotion first = path.between(10.5, 12.25), second = path.between(12.25, 14);
  expectPose(compose(first.increment, second.increment), path.between(10.5, 14).increment);
  EXPECT_NEAR(first.path_length + second.path_length, path.between(10.5, 14).path_length, 1e-12);
  EXPECT_NEAR(first.turned + second.turned, path.between(10.5, 14).turned, 1e-12);
}

TEST(OdometryPath, GoesBackInTimeToo)
{
  const OdometryPath path(kRecords, {});
  expectPose(compose(path.between(10, 14).increment, path.between(14, 10).increment), {});
}

TEST(OdometryPath, ScalesDistancesAndRotationsIndependently)
{
  const std::vector<OdometryRecord> square{{0, {0, 0, 0}}, {1, {1, 0, kPi / 2}}, {2, {1, 1, kPi}}};
  expectPose(OdometryPath(square, {.scale = 2}).at(2), {2, 2, kPi});
  EXPECT_NEAR(OdometryPath(square, {.scale = 2}).between(0, 2).path_length, 4, 1e-12);
  EXPECT_NEAR(OdometryPath(square, {.scale = 2}).between(0, 2).turned, kPi, 1e-12);
  expectPose(OdometryPath(square, {.rotation_scale = 2}).at(2), {0, 0, 0});
  EXPECT_NEAR(OdometryPath(square, {.rotation_scale = 2}).between(0, 2).path_length, 2, 1e-12);
}

TEST(OdometryPath, AnXAxisFurtherLeftMovesTheRobotToItsLeft)
{
  const std::vector<OdometryRecord> square{{0, {0, 0, 0}}, {1, {1, 0, kPi / 2}}, {2, {1, 1, kPi}}};
  const OdometryPath path(square, {.scale = 2, .yaw = kPi / 2});
  expectPose(path.at(1), {0, 2, kPi / 2});
  expectPose(path.at(2), {-2, 2, kPi});
  EXPECT_NEAR(path.between(0, 2).path_length, 4, 1e-12);
}

TEST(OdometryPath, DistancePerTurnCountsOnArcsOfEitherSide)
{
  const std::vector<OdometryRecord> records{{0, {0, 0, 0}},    {1, {1, 0, 0}}, {2, {1, 0, 0.5}}, {3, {1, 0, 0}},
                                            {4, {2, 0, -0.5}}, {5, {2, 0, 0}}, {6, {1, 0, 0.5}}};
  const OdometryPath path(records, {.scale = 2, .distance_per_turn = -0.2});
  EXPECT_NEAR(path.between(0, 1).path_length, 2, 1e-12) << "straight";
  EXPECT_NEAR(path.between(1, 3).path_length, 0, 1e-12) << "in place";
  expectPose(path.between(3, 4).increment, {1.8, 0, -0.5});
  expectPose(path.between(5, 6).increment, {-1.8, 0, 0.5});
  // An arc does not become a turn in place.
  EXPECT_NEAR(OdometryPath(records, {.distance_per_turn = -3}).between(3, 4).path_length, 0.05, 1e-12);
  EXPECT_NEAR(OdometryPath(records, {.distance_per_turn = 0.4}).between(3, 4).path_length, 1.2, 1e-12);
}

TEST(OdometryPath, ScalesTurnsInPlaceApart)
{
  const std::vector<OdometryRecord> records{{0, {0, 0, 0}}, {1, {0, 0, 0.5}}, {2, {0, 1, 1.5}}};
  const OdometryPath path(records, {.rotation_scale = 0.5, .pivot_scale = 4});
  EXPECT_NEAR(path.between(0, 1).increment.phi, 1, 1e-12);
  EXPECT_NEAR(path.between(1, 2).increment.phi, 0.5, 1e-12);
}

TEST(OdometryPath, TurnPerMetreGrowsWithTheDistance)
{
  const std::vector<OdometryRecord> straight{{0, {0, 0, 0}}, {1, {2, 0, 0}}, {2, {2, 0, 0}}, {3, {3, 0, 0}}};
  const OdometryPath path(straight, {.scale = 0.5, .turn_per_m = 0.2});
  EXPECT_NEAR(path.at(1).phi, 0.2, 1e-12);
  EXPECT_NEAR(path.at(2).phi, 0.2, 1e-12);
  EXPECT_NEAR(path.at(3).phi, 0.3, 1e-12);
  EXPECT_NEAR(path.between(0, 3).turned, 0.3, 1e-12);
}

TEST(OdometryPath, TurnPerSecondGrowsWithTimeAlsoAtRest)
{
  const std::vector<OdometryRecord> resting{{5, {0, 0, 0}}, {6, {2, 0, 0}}, {8, {2, 0, 0}}};
  const OdometryPath path(resting, {.turn_per_s = -0.1, .delay = 1});
  EXPECT_NEAR(path.at(7).phi, -0.1, 1e-12);
  EXPECT_NEAR(path.at(9).phi, -0.3, 1e-12);
}

TEST(OdometryPath, TheDelayIsAddedToTheStamps)
{
  const OdometryPath path(kRecords, {.delay = 0.5});
  expectPose(path.at(11.5), {1, 0, 3});
  EXPECT_EQ(path.trajectory().front().time, 10.5);
}

TEST(OdometryPath, TakesRecordsInAnyOrderAndAtEqualTimes)
{
  const OdometryPath path({{2, {2, 0, 0}}, {0, {0, 0, 0}}, {2, {2.5, 0, 0}}, {1, {1, 0, 0}}}, {});
  expectPose(path.at(1.5), {1.5, 0, 0});
  expectPose(path.at(2), {2.5, 0, 0});
  EXPECT_NEAR(path.between(0, 3).path_length, 2.5, 1e-12);
}

TEST(OdometryPath, WithoutRecordsNothingMoves)
{
  const OdometryPath path({}, {});
  EXPECT_TRUE(path.empty());
  expectPose(path.between(1, 4).increment, {});
  EXPECT_EQ(path.between(1, 4).duration, 3);
}

// Half a metre per second, ten records a second, from (3, 2).
std::vector<OdometryRecord> driven(int records)
{
  std::vector<OdometryRecord> result;
  for (int k = 0; k < records; ++k) result.push_back({0.1 * k, {3 + 0.05 * k, 2, 0}});
  return result;
}

OdometryPath recorded(const std::vector<OdometryRecord>& records)
{
  OdometryPath path;
  for (const OdometryRecord& record : records) path.add(record);
  return path;
}

TEST(OdometryPath, AJumpIsNoMotion)
{
  std::vector<OdometryRecord> records = driven(60);
  for (std::size_t k = 40; k < 60; ++k) records[k].pose.x -= 4;
  const OdometryPath path = recorded(records);
  EXPECT_EQ(path.jumps().count(), 1u);
  EXPECT_NEAR(path.jumps().longest(), 3.95, 1e-9);
  EXPECT_NEAR(path.jumps().timeOfLongest(), 4, 1e-9);
  EXPECT_NEAR(path.between(0, 5.9).increment.x, 58 * 0.05, 1e-9) << "all steps but that one";
}

TEST(OdometryPath, ADamagedRecordIsNoMotionThereAndBack)
{
  for (const Pose2& damaged : {Pose2{100, -30, 0}, Pose2{0, 0, 0}})
  {
    std::vector<OdometryRecord> records = driven(60);
    records[40].pose = damaged;
    const OdometryPath path = recorded(records);
    EXPECT_EQ(path.jumps().count(), 2u);
    EXPECT_NEAR(path.between(0, 5.9).increment.x, 57 * 0.05, 1e-9);
    EXPECT_NEAR(path.between(0, 5.9).increment.y, 0, 1e-9);
  }
}

TEST(OdometryPath, ADriverThatIsStartedAnewBeginsAtTheOrigin)
{
  std::vector<OdometryRecord> records = driven(60);
  const Pose2 last = records.back().pose;
  records.push_back({15, {0, 0, 0}});
  records.push_back({15.1, {0.05, 0, 0}});
  const OdometryPath path = recorded(records);
  EXPECT_EQ(path.jumps().count(), 1u);
  expectPose(path.at(15.1), {last.x + 0.05, last.y, 0});
}

TEST(OdometryPath, AJumpAfterALongPauseIsOne)
{
  std::vector<OdometryRecord> records = driven(60);
  for (int k = 0; k < 60; ++k) records.push_back({600 + 0.1 * k, {k < 30 ? 6.0 : 15.0, 2, 0}});
  EXPECT_EQ(recorded(records).jumps().count(), 1u);
}

TEST(OdometryPath, AFastRobotJumpsAtItsFirstStepAlone)
{
  std::vector<OdometryRecord> records;
  for (int k = 0; k < 40; ++k) records.push_back({0.1 * k, {1, 0, 0}});
  for (int k = 0; k < 40; ++k) records.push_back({4 + 0.1 * k, {1 + 2.0 * k, 0, 0}});
  EXPECT_EQ(recorded(records).jumps().count(), 1u);
}

TEST(OdometryPath, ARoundTripIsNoJump)
{
  std::vector<OdometryRecord> records;
  for (int k = 0; k <= 20; ++k) records.push_back({0.1 * k, {0.05 * (10 - std::abs(k - 10)), 0, 0}});
  for (int k = 0; k < 100; ++k) records.push_back({3.0 + k, {k % 2 == 0 ? 0 : 0.001, 0, 0}});
  EXPECT_EQ(recorded(records).jumps().count(), 0u) << "back to the origin as it went, and wheels that jitter there";
}

TEST(OdometryPath, APathWithoutJumpsIsTakenAsItIs)
{
  std::vector<OdometryRecord> records = driven(60);
  for (std::size_t k = 40; k < 60; ++k) records[k].pose.x -= 4;
  EXPECT_EQ(OdometryPath(records, {}).jumps().count(), 0u);
}

TEST(MotionBetween, IsInTheFrameOfTheEarlierPose)
{
  const Pose2 motion = motionBetween(kUpwards, 0.5, 1.5);
  EXPECT_NEAR(motion.x, 1, 1e-12);
  EXPECT_NEAR(motion.y, 0, 1e-12);
  EXPECT_NEAR(motion.phi, 0, 1e-12);
}

TEST(MotionBetween, HoldsItsEndsAndIsIdentityWithoutOdometry)
{
  EXPECT_NEAR(motionBetween(kUpwards, 1.0, 9.0).x, 1, 1e-12);
  EXPECT_NEAR(motionBetween(kUpwards, -9.0, 1.0).x, 1, 1e-12);
  EXPECT_EQ(motionBetween({}, 0, 1).x, 0);
}

TEST(Propagate, MovesTheEstimateInItsOwnHeading)
{
  const PoseEstimate propagated = propagate(estimateAt(0, {1, 1, 0}), kUpwards, 2);
  EXPECT_DOUBLE_EQ(propagated.time, 2);
  EXPECT_NEAR(propagated.pose.mean.x, 3, 1e-12);
  EXPECT_NEAR(propagated.pose.mean.y, 1, 1e-12);
}

TEST(Propagate, HeadingVarianceBecomesCrossTrackVariance)
{
  PoseEstimate estimate = estimateAt(0, {1, 1, 0});
  estimate.pose.covariance(2, 2) = 0.04;
  const Matrix3d P = propagate(estimate, kUpwards, 2).pose.covariance;
  EXPECT_NEAR(P(0, 0), 0, 1e-12);
  EXPECT_NEAR(P(1, 1), 4 * 0.04, 1e-12);
}

TEST(Propagate, WithoutHeadingTheEstimateStays)
{
  PoseEstimate estimate = estimateAt(0, {1, 1, 0});
  estimate.heading_known = false;
  EXPECT_DOUBLE_EQ(propagate(estimate, kUpwards, 2).pose.mean.x, 1);
}
}  // namespace mrpt_ext::test_odometry_path
