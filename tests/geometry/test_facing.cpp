#include "mrpt_ext/geometry/facing.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_facing
{
TEST(Facing, TheLikelierAttitudeComesFirst)
{
  const Facing facing = Facing::either({.yaw = 1, .std = 0.1}, {.yaw = -4, .std = 0.2}, 0.7);
  EXPECT_NEAR(facing.attitudes[0].yaw, kTwoPi - 4, 1e-12);
  EXPECT_EQ(facing.attitudes[0].std, 0.2);
  EXPECT_EQ(facing.attitudes[0].weight, 0.7);
  EXPECT_EQ(facing.attitudes[1].yaw, 1);
  EXPECT_NEAR(facing.attitudes[1].weight, 0.3, 1e-12);
}

TEST(Facing, OneAttitudeIsCertain)
{
  const Facing facing = Facing::single(4, 0.1);
  EXPECT_NEAR(facing.attitudes[0].yaw, 4 - kTwoPi, 1e-12);
  EXPECT_EQ(facing.attitudes[0].weight, 1);
  EXPECT_EQ(facing.attitudes[1].weight, 0);
}

TEST(Facing, AxesThatAreTurnedSeeItTurnedBack)
{
  EXPECT_NEAR(turnedBack(Facing::single(-3, 0.1), 0.5).attitudes[0].yaw, kTwoPi - 3.5, 1e-12);
}

TEST(Facing, VariancesAreAddedAndTakenOff)
{
  const Facing wide = widened(Facing::single(1, 0.3), square(0.4));
  EXPECT_NEAR(wide.attitudes[0].std, 0.5, 1e-12);
  EXPECT_NEAR(widened(wide, -square(0.4)).attitudes[0].std, 0.3, 1e-12);
  const double least = widened(wide, -square(0.5) - 1e-12).attitudes[0].std;
  EXPECT_GT(least, 0);
  EXPECT_LT(least, 1e-3);
}
}  // namespace mrpt_ext::test_facing
