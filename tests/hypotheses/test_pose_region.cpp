#include "mrpt_ext/hypotheses/pose_region.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_pose_region
{
namespace
{
/// Integral of the region's density over a box that contains it, on a grid of cell centres.
double integral(const PoseRegion& region, double half_width)
{
  const int n = 80;
  const double cell = 2 * half_width / n, turn = kTwoPi / n;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        sum +=
            region.density({-half_width + (i + 0.5) * cell, -half_width + (j + 0.5) * cell, -kPi + (k + 0.5) * turn});
  return sum * cell * cell * turn;
}
}  // namespace

TEST(PoseRegion, DensityIntegratesToOne)
{
  EXPECT_NEAR(integral({{-1, -2}, {2, 1.5}}, 4), 1, 1e-9);
  EXPECT_NEAR(integral({{-1, -2}, {2, 1.5}, kPi / 2, kPi}, 4), 1, 1e-9);  // closes over the seam at pi
}

TEST(PoseRegion, HeadingIntervalClosesAtPi)
{
  const PoseRegion region{{0, 0}, {1, 1}, degToRad(170), degToRad(20)};
  for (const double inside : {171.0, 180.0, -175.0}) EXPECT_TRUE(region.contains({0.5, 0.5, degToRad(inside)}));
  for (const double outside : {169.0, -169.0, 0.0}) EXPECT_FALSE(region.contains({0.5, 0.5, degToRad(outside)}));
}

TEST(PoseRegion, SamplesFillTheRegionAndStayInside)
{
  const PoseRegion region{{-1, 2}, {3, 5}, 2.5, 2.0};
  RandomStream random(7);
  const int n = 20000;
  Vector2d sum = Vector2d::Zero();
  double turned = 0;
  for (int i = 0; i < n; ++i)
  {
    const Pose2 pose = region.sample(random);
    ASSERT_TRUE(region.contains(pose));
    sum += pose.position();
    turned += wrap(pose.phi - 3.5);
  }
  EXPECT_NEAR(sum.x() / n, 1.0, 4 * 4 / std::sqrt(12.0 * n));
  EXPECT_NEAR(sum.y() / n, 3.5, 4 * 3 / std::sqrt(12.0 * n));
  EXPECT_NEAR(turned / n, 0.0, 4 * 2 / std::sqrt(12.0 * n));
}

TEST(PoseRegion, ARegionWithoutExtentStillHasAFiniteDensityWhereItIs)
{
  const PoseRegion point{{2, 3}, {2, 3}, 1.0, 0.0};
  RandomStream random(1);
  for (int i = 0; i < 100; ++i)
  {
    const Pose2 pose = point.sample(random);
    EXPECT_NEAR(pose.x, 2, 0.01);
    EXPECT_NEAR(pose.y, 3, 0.01);
    EXPECT_NEAR(pose.phi, 1, 0.01);
    EXPECT_TRUE(std::isfinite(point.density(pose)));
    EXPECT_GT(point.density(pose), 0);
  }
  EXPECT_EQ(point.density({2.5, 3, 1}), 0);
}
}  // namespace mrpt_ext::test_pose_region
