#include "mrpt_ext/calibration/robust_loss.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_robust_loss
{
TEST(RobustLoss, IsTheSquareUpToTwoAndAHalfDeviations)
{
  for (const double e : {0.0, 1.0, 2.0, 2.49})
  {
    EXPECT_EQ(robust::loss(square(e)), square(e));
    EXPECT_EQ(robust::weight(square(e)), 1);
    EXPECT_EQ(robust::curvature(square(e)), 1);
  }
}

TEST(RobustLoss, OutliersHardlyCount)
{
  EXPECT_LT(robust::weight(100), 0.03);
  EXPECT_LT(robust::loss(1e6), 23);
  EXPECT_LT(robust::curvature(100), 0);
}

TEST(RobustLoss, WeightAndCurvatureAreItsDerivatives)
{
  constexpr double kStep = 1e-4;
  for (const double e : {1.0, 3.0, 4.0, 6.0, 12.0})
  {
    const auto half_loss = [](double x) { return robust::loss(square(x)) / 2; };
    const double slope = (half_loss(e + kStep) - half_loss(e - kStep)) / (2 * kStep);
    const double second = (half_loss(e + kStep) - 2 * half_loss(e) + half_loss(e - kStep)) / square(kStep);
    EXPECT_NEAR(slope, robust::weight(square(e)) * e, 1e-6) << e;
    EXPECT_NEAR(second, robust::curvature(square(e)), 1e-5) << e;
  }
}

TEST(RobustLoss, AMixtureTellsOutliers)
{
  const robust::Mixture mixture(1e-3);
  EXPECT_EQ(mixture.loss(0), 0);
  EXPECT_GT(mixture.weight(square(2.5)), 0.95);
  EXPECT_LT(mixture.weight(square(5.0)), 0.01);
  EXPECT_EQ(mixture.weight(1e6), 0);
  EXPECT_EQ(mixture.curvature(1e6), 0);
  EXPECT_TRUE(std::isfinite(mixture.loss(1e6)));
  constexpr double kStep = 1e-4;
  for (const double e : {1.0, 3.0, 4.0, 6.0})
  {
    const auto half_loss = [&](double x) { return mixture.loss(square(x)) / 2; };
    const double slope = (half_loss(e + kStep) - half_loss(e - kStep)) / (2 * kStep);
    const double second = (half_loss(e + kStep) - 2 * half_loss(e) + half_loss(e - kStep)) / square(kStep);
    EXPECT_NEAR(slope, mixture.weight(square(e)) * e, 1e-6) << e;
    EXPECT_NEAR(second, mixture.curvature(square(e)), 1e-5) << e;
  }
}
}  // namespace mrpt_ext::test_robust_loss
