#include "mrpt_ext/geometry/trajectory.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_trajectory
{
namespace
{
const Trajectory kTwoPoses{{1.0, {0, 0, 3.0}, true}, {1.4, {4, 8, -3.0}, true}, {5.0, {9, 9, 0}, false}};
}

TEST(Interpolate, HeadingTakesTheShorterArc)
{
  const auto middle = interpolate(kTwoPoses, 1.2, 0.5);
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->pose.x, 2, 1e-9);
  EXPECT_NEAR(middle->pose.y, 4, 1e-9);
  EXPECT_NEAR(std::abs(wrap(middle->pose.phi - kPi)), 0, 1e-9);
}

TEST(Interpolate, ExactStampNeedsNoNeighbour)
{
  ASSERT_TRUE(interpolate(kTwoPoses, 5.0, 0.5));
  EXPECT_FALSE(interpolate(kTwoPoses, 5.0, 0.5)->heading_known);
  EXPECT_TRUE(interpolate(kTwoPoses, 1.0, 0.5));
}

TEST(Interpolate, LongGapsAndOutsideGiveNothing)
{
  EXPECT_FALSE(interpolate(kTwoPoses, 3.0, 0.5));
  EXPECT_FALSE(interpolate(kTwoPoses, 0.9, 0.5));
  EXPECT_FALSE(interpolate(kTwoPoses, 5.1, 0.5));
  EXPECT_FALSE(interpolate({}, 0, 1));
}
}  // namespace mrpt_ext::test_trajectory
