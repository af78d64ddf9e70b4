#include "mrpt_ext/evaluation/dead_reckoning.h"

#include <gtest/gtest.h>

namespace mrpt_ext
{
namespace
{
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

TEST(Carry, MovesTheEstimateInItsOwnHeading)
{
  const PoseEstimate carried = carry(estimateAt(0, {1, 1, 0}), kUpwards, 2);
  EXPECT_DOUBLE_EQ(carried.time, 2);
  EXPECT_NEAR(carried.pose.mean.x, 3, 1e-12);
  EXPECT_NEAR(carried.pose.mean.y, 1, 1e-12);
}

TEST(Carry, HeadingVarianceBecomesCrossTrackVariance)
{
  PoseEstimate estimate = estimateAt(0, {1, 1, 0});
  estimate.pose.covariance(2, 2) = 0.04;
  const Matrix3d P = carry(estimate, kUpwards, 2).pose.covariance;
  EXPECT_NEAR(P(0, 0), 0, 1e-12);
  EXPECT_NEAR(P(1, 1), 4 * 0.04, 1e-12);
}

TEST(Carry, WithoutHeadingTheEstimateStays)
{
  PoseEstimate estimate = estimateAt(0, {1, 1, 0});
  estimate.heading_known = false;
  EXPECT_DOUBLE_EQ(carry(estimate, kUpwards, 2).pose.mean.x, 1);
}
}  // namespace mrpt_ext
