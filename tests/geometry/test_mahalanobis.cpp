#include "mrpt_ext/geometry/mahalanobis.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_mahalanobis
{
TEST(Mahalanobis, CountsStandardDeviationsAcrossTheHalfTurn)
{
  const Matrix3d covariance = Vector3d(0.04, 0.09, 0.01).asDiagonal();
  const Pose2 a{1, 2, kPi - 0.05}, b{1.2, 1.7, -kPi + 0.05};
  EXPECT_NEAR(mahalanobis2(a, b, covariance), 1 + 1 + 1, 1e-9);
  EXPECT_EQ(mahalanobis2(a, a, covariance), 0);
}

TEST(Mahalanobis, CorrelationMakesTheCommonDirectionNearer)
{
  Matrix3d covariance = Matrix3d::Identity();
  covariance(0, 1) = covariance(1, 0) = 0.8;
  EXPECT_NEAR(mahalanobis2({1, 1, 0}, {0, 0, 0}, covariance), 2 / 1.8, 1e-12);
  EXPECT_NEAR(mahalanobis2({1, -1, 0}, {0, 0, 0}, covariance), 2 / 0.2, 1e-12);
}

TEST(IsWithin, ChecksEachCoordinate)
{
  const GaussianPose gaussian{{1, 2, 3.1}, Vector3d(0.04, 0.09, 0.01).asDiagonal()};
  EXPECT_TRUE(isWithin(gaussian, {1.19, 1.71, 3.0}, 1.01));
  EXPECT_FALSE(isWithin(gaussian, {1.21, 2, 3.1}, 1));
  EXPECT_FALSE(isWithin(gaussian, {1, 1.69, 3.1}, 1));
  EXPECT_FALSE(isWithin(gaussian, {1, 2, wrap(3.25)}, 1));
  EXPECT_TRUE(isWithin(gaussian, {1, 2, wrap(3.25)}, 2));
}
}  // namespace mrpt_ext::test_mahalanobis
