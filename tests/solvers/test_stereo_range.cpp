#include "mrpt_ext/solvers/stereo_range.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_stereo_range
{
TEST(StereoRange, StraightAheadByHand)
{
  const StereoRange r = stereoRange({500, 0.1}, 25, 0.5, 0, 1);  // f B = 50, depth 2
  ASSERT_EQ(r.status, SolveStatus::ok);
  EXPECT_NEAR(r.depth, 2, 1e-12);
  EXPECT_NEAR(r.range, 2, 1e-12);
  EXPECT_NEAR(r.bearing, 0, 1e-12);
  EXPECT_NEAR(r.std_depth, 4 * 0.5 / 50, 1e-12);
  EXPECT_NEAR(r.covariance(1, 1), square(1.0 / 500), 1e-15);
}

TEST(StereoRange, RightOfTheAxisIsANegativeBearing)
{
  const StereoRange r = stereoRange({500, 0.1}, 25, 0.5, 500, 1);
  EXPECT_NEAR(r.bearing, -kPi / 4, 1e-12);
  EXPECT_NEAR(r.range, 2 * std::sqrt(2.0), 1e-12);
}

TEST(StereoRange, FocalLengthFromFieldOfView) { EXPECT_NEAR(focalLengthFromFieldOfView(640, kPi / 2), 320, 1e-9); }

TEST(StereoRange, CovarianceAndBiasMatchTheScatter)
{
  RandomStream random(71);
  const StereoRig rig{400, 0.12};
  const StereoRange exact = stereoRange(rig, 16, 0.8, 150, 1.5);
  Matrix2d scatter = Matrix2d::Zero();
  double bias = 0;
  const int trials = 20000;
  for (int trial = 0; trial < trials; ++trial)
  {
    const StereoRange r = stereoRange(rig, 16 + 0.8 * random.gaussian(), 0.8, 150 + 1.5 * random.gaussian(), 1.5);
    const Vector2d e(r.range - exact.range, r.bearing - exact.bearing);
    scatter += e * e.transpose() / trials;
    bias += (r.depth - exact.depth) / trials;
  }
  EXPECT_NEAR(scatter(0, 0) / exact.covariance(0, 0), 1, 0.06);
  EXPECT_NEAR(scatter(1, 1) / exact.covariance(1, 1), 1, 0.06);
  EXPECT_NEAR(bias, exact.expected_bias, 0.5 * exact.expected_bias);
}

TEST(StereoRange, NoDisparityIsNoRange)
{
  EXPECT_EQ(stereoRange({500, 0.1}, 0, 0.5, 0, 1).status, SolveStatus::none);
  EXPECT_EQ(stereoRange({500, 0.1}, -3, 0.5, 0, 1).status, SolveStatus::none);
  EXPECT_EQ(stereoRange({0, 0.1}, 3, 0.5, 0, 1).status, SolveStatus::bad_input);
}
}  // namespace mrpt_ext::test_stereo_range
