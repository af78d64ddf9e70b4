#include "mrpt_ext/importers/velocity_odometry.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mrpt_ext::test_velocity_odometry
{
TEST(ArcMotion, QuarterCircleStraightLineAndTurnOnTheSpot)
{
  const Pose2 quarter = arcMotion(1.0, kPi / 2, 1.0);  // radius 2 / pi
  EXPECT_NEAR(quarter.x, 2 / kPi, 1e-12);
  EXPECT_NEAR(quarter.y, 2 / kPi, 1e-12);
  EXPECT_NEAR(quarter.phi, kPi / 2, 1e-12);
  const Pose2 straight = arcMotion(-0.5, 0, 3);
  EXPECT_EQ(straight.vector(), Vector3d(-1.5, 0, 0));
  EXPECT_EQ(arcMotion(0, 1, 2).vector(), Vector3d(0, 0, 2));
}

TEST(ArcMotion, IsSmoothWhereTheSeriesTakesOver)
{
  const Pose2 series = arcMotion(1, 1.999e-4, 1), closed = arcMotion(1, 2.001e-4, 1);
  const double turn = 2e-4, step = 2e-7;
  EXPECT_NEAR(series.x - closed.x, step * turn / 3, 1e-15);  // x = 1 - turn^2 / 6
  EXPECT_NEAR(closed.y - series.y, step / 2, 1e-14);         // y = turn / 2
}

RC_GTEST_PROP(ArcMotion, TwoHalvesMakeTheWhole, ())
{
  const double v = *rc::gen::inRange(-3000, 3000) * 1e-3, omega = *rc::gen::inRange(-6000, 6000) * 1e-3;
  const double duration = *rc::gen::inRange(1, 3000) * 1e-3;
  const Pose2 half = arcMotion(v, omega, duration / 2), whole = arcMotion(v, omega, duration);
  const Pose2 twice = compose(half, half);
  RC_ASSERT((twice.position() - whole.position()).norm() < 1e-9);
  RC_ASSERT(std::abs(wrap(twice.phi - whole.phi)) < 1e-9);
}

TEST(IntegrateVelocities, VelocityHoldsUntilTheNextRecord)
{
  const auto odometry = integrateVelocities({{0, 1, 0}, {2, 0.5, kPi}, {3, 7, 7}});
  ASSERT_EQ(odometry.size(), 3u);
  EXPECT_EQ(odometry[1].pose.vector(), Vector3d(2, 0, 0));
  EXPECT_NEAR(odometry[2].pose.x, 2, 1e-12);
  EXPECT_NEAR(odometry[2].pose.y, 1 / kPi, 1e-12);  // half circle of radius 0.5 / pi
  EXPECT_NEAR(std::abs(wrap(odometry[2].pose.phi - kPi)), 0, 1e-12);
}

TEST(IntegrateVelocities, OfOneStampTheLastVelocityHolds)
{
  const auto odometry = integrateVelocities({{0, 1, 0}, {1, 100, 0}, {1, 2, 0}, {2, 0, 0}});
  ASSERT_EQ(odometry.size(), 3u);
  EXPECT_EQ(odometry[1].pose.x, 1);
  EXPECT_EQ(odometry[2].pose.x, 3);
}
}  // namespace mrpt_ext::test_velocity_odometry
