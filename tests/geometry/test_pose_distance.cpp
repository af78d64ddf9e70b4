#include "mrpt_ext/geometry/pose_distance.h"

#include <gtest/gtest.h>

namespace mrpt_ext
{
namespace
{
GaussianPose correlated()
{
  GaussianPose gaussian{{1, 2, 3.1}, Vector3d(0.04, 0.09, 0.01).asDiagonal()};
  gaussian.covariance(0, 1) = gaussian.covariance(1, 0) = 0.03;
  return gaussian;
}
}  // namespace

TEST(Mahalanobis2, IsTheSquaredDistanceInStandardDeviations)
{
  const GaussianPose gaussian{{1, 2, 3.1}, Vector3d(0.04, 0.09, 0.01).asDiagonal()};
  EXPECT_NEAR(mahalanobis2(gaussian, gaussian.mean), 0, 1e-12);
  EXPECT_NEAR(mahalanobis2(gaussian, {1.4, 2, 3.1}), 4, 1e-9);
  EXPECT_NEAR(mahalanobis2(gaussian, {1, 1.7, 3.1}), 1, 1e-9);
  EXPECT_NEAR(mahalanobis2(gaussian, {1, 2, wrap(3.3)}), 4, 1e-9);  // across the half turn
}

TEST(Mahalanobis2, HeedsCorrelations)
{
  // Inverse of (0.04, 0.03; 0.03, 0.09) by hand: determinant 0.0027.
  EXPECT_NEAR(mahalanobis2(correlated(), {1.2, 2.3, 3.1}), (0.09 * 0.04 - 2 * 0.03 * 0.06 + 0.04 * 0.09) / 0.0027,
              1e-9);
}

TEST(IsWithin, ChecksEachCoordinate)
{
  EXPECT_TRUE(isWithin(correlated(), {1.19, 1.71, 3.0}, 1.01));
  EXPECT_FALSE(isWithin(correlated(), {1.21, 2, 3.1}, 1));
  EXPECT_FALSE(isWithin(correlated(), {1, 1.69, 3.1}, 1));
  EXPECT_FALSE(isWithin(correlated(), {1, 2, wrap(3.25)}, 1));
  EXPECT_TRUE(isWithin(correlated(), {1, 2, wrap(3.25)}, 2));
}
}  // namespace mrpt_ext
