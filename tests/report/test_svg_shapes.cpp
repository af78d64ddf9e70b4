#include "mrpt_ext/report/svg_shapes.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_svg_shapes
{
TEST(NiceStep, IsOneTwoOrFive)
{
  EXPECT_NEAR(niceStep(0.034), 0.02, 1e-12);
  EXPECT_NEAR(niceStep(1), 1, 1e-12);
  EXPECT_NEAR(niceStep(7.7), 5, 1e-12);
  EXPECT_NEAR(niceStep(1000), 1000, 1e-9);
  EXPECT_EQ(niceText(0.04, 0.02), "0.04");
  EXPECT_EQ(niceText(40, 20), "40");
}

TEST(ThinnedByDistance, KeepsBothEnds)
{
  SvgPoints points;
  for (int i = 0; i <= 100; ++i) points.emplace_back(0.1 * i, 0);
  const SvgPoints thin = thinnedByDistance(points, 1.05);
  EXPECT_EQ(thin.front().x(), 0);
  EXPECT_EQ(thin.back().x(), 10);
  EXPECT_LT(thin.size(), 12u);
  EXPECT_TRUE(thinnedByDistance({}, 1).empty());
}
}  // namespace mrpt_ext::test_svg_shapes
