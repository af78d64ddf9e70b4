#include "mrpt_ext/evaluation/posterior_bound.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "posterior_bounds.h"

namespace mrpt_ext::test_posterior_bound
{
TEST(PosteriorBound, WithoutMeasurementsVariancesAddUp)
{
  const BoundStep step{{1, 0, 0}, {0.1, 0.2, 0}, Matrix3d::Zero()};
  const auto bounds = testing::posteriorBounds({}, Matrix3d::Identity() * 1e-6, {step, step});
  ASSERT_EQ(bounds.size(), 2u);
  EXPECT_NEAR(bounds[1](0, 0), 2 * 0.01, 1e-5);
  EXPECT_NEAR(bounds[1](1, 1), 2 * 0.04, 1e-5);
}

TEST(PosteriorBound, AMeasurementOnlyEverHelps)
{
  BoundStep blind{{0.5, 0, 0.1}, {0.05, 0.01, 0.02}, Matrix3d::Zero()}, seeing = blind;
  addInformation(seeing.measurement_information, bearingJacobian({0.5, 0, 0.1}, {4, 3}), 0.02);
  const Matrix3d prior = Vector3d(0.3, 0.3, 0.05).asDiagonal();
  const Matrix3d gain =
      testing::posteriorBounds({}, prior, {blind})[0] - testing::posteriorBounds({}, prior, {seeing})[0];
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix3d>(gain).eigenvalues()[0], -1e-12);
  EXPECT_GT(gain.trace(), 1e-6);
}

TEST(PosteriorBound, NoiseFreeOdometryIsAllowed)
{
  const BoundStep step{{0.5, 0, 0.1}, {0, 0, 0}, Matrix3d::Identity()};
  const Matrix3d bound = testing::posteriorBounds({}, Matrix3d::Identity(), {step})[0];
  EXPECT_TRUE(bound.allFinite());
  EXPECT_LT(bound(0, 0), 1);
}
}  // namespace mrpt_ext::test_posterior_bound
