#include "mrpt_ext/simulation/robot_path.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mrpt_ext::test_robot_path
{
TEST(ArcMotion, StraightLineTurnInPlaceAndQuarterCircle)
{
  EXPECT_DOUBLE_EQ(arcMotion(2, 0, 3).x, 6);
  EXPECT_DOUBLE_EQ(arcMotion(2, 0, 3).y, 0);
  EXPECT_DOUBLE_EQ(arcMotion(0, 0.5, 2).phi, 1);
  const Pose2 quarter = arcMotion(kPi / 2, kPi / 2, 1);  // radius 1
  EXPECT_NEAR(quarter.x, 1, 1e-12);
  EXPECT_NEAR(quarter.y, 1, 1e-12);
  EXPECT_NEAR(quarter.phi, kPi / 2, 1e-12);
}

RC_GTEST_PROP(ArcMotion, TwoHalvesMakeAWhole, (int speed_cm, int rate_mrad, unsigned int time_ms))
{
  const double v = (speed_cm % 300) / 100.0, w = (rate_mrad % 3000) / 1000.0, t = (time_ms % 5000) / 1000.0;
  const Pose2 whole = arcMotion(v, w, t), halves = compose(arcMotion(v, w, t / 2), arcMotion(v, w, t / 2));
  RC_ASSERT((whole.position() - halves.position()).norm() < 1e-9);
  RC_ASSERT(std::abs(wrap(whole.phi - halves.phi)) < 1e-9);
}

TEST(RobotPath, FollowsItsSegmentsAndThenStands)
{
  const RobotPath path({1, 2, 0}, {{2, 0.5, 0}, {1, 0, -kPi / 2}, {4, 0.25, 0}});
  EXPECT_DOUBLE_EQ(path.duration(), 7);
  EXPECT_DOUBLE_EQ(path.poseAt(-1).x, 1);
  EXPECT_DOUBLE_EQ(path.poseAt(1).x, 1.5);
  EXPECT_NEAR(path.poseAt(2.5).phi, -kPi / 4, 1e-12);
  EXPECT_NEAR(path.poseAt(7).y, 1, 1e-12);
  EXPECT_NEAR(path.poseAt(100).y, 1, 1e-12);
  EXPECT_NEAR(path.lengthAt(5), 1.5, 1e-12);
  EXPECT_NEAR(path.turnedAt(5), kPi / 2, 1e-12);
  EXPECT_NEAR(path.lengthAt(100), 2, 1e-12);
}
}  // namespace mrpt_ext::test_robot_path
