#include "mrpt_ext/filter/consider/place_variance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mrpt_ext::test_place_variance
{
namespace
{
constexpr double kAssumed = 0.05;  // [m]

/// A sensor was found `apart` [m] from the point that odometry follows in both axes, known to `std` [m]: of two places
/// the difference alone. Order: x and y of the one, x and y of the other.
LinearEvidence difference(double apart, double std)
{
  Eigen::Matrix<double, 2, 4> rows;
  rows << 1, 0, -1, 0, 0, 1, 0, -1;
  return {rows.transpose() * rows / (std * std), rows.transpose() * Eigen::Vector2d::Constant(apart) / (std * std)};
}

double stdOf(const LinearEvidence& evidence) { return std::sqrt(placeVariance(evidence, kAssumed)); }

TEST(PlaceVariance, IsAsAssumedWhileNothingIsTold)
{
  EXPECT_NEAR(stdOf({Eigen::MatrixXd::Zero(4, 4), Eigen::VectorXd::Zero(4)}), kAssumed, 1e-6);
  EXPECT_NEAR(stdOf(difference(0, 1)), kAssumed, 0.002);
  EXPECT_NEAR(stdOf({Eigen::MatrixXd::Zero(0, 0), Eigen::VectorXd::Zero(0)}), kAssumed, 1e-6);
}

TEST(PlaceVariance, PlacesThatAgreeWereStatedWell)
{
  EXPECT_LT(stdOf(difference(0, 0.001)), 0.2 * kAssumed);
  EXPECT_LT(stdOf(difference(0, 0.02)), 0.8 * kAssumed);
  EXPECT_GT(stdOf(difference(0, 0.02)), 0.3 * kAssumed);
}

TEST(PlaceVariance, PlacesThatDisagreeWereStatedBadly)
{
  EXPECT_GT(stdOf(difference(0.15, 0.001)), 1.4 * kAssumed);
  const double typical = stdOf(difference(0.05, 0.001));
  EXPECT_GT(typical, 0.7 * kAssumed);
  EXPECT_LT(typical, 1.3 * kAssumed);
}

TEST(PlaceVariance, StaysFiniteWhateverIsTold)
{
  for (const double apart : {0.0, 1.0, 1e6})
    for (const double std : {1e-9, 1.0, 1e9})
    {
      const double found = stdOf(difference(apart, std));
      EXPECT_GE(found, 0.06 * kAssumed);
      EXPECT_LE(found, 2.2 * kAssumed);
    }
}
}  // namespace
}  // namespace mrpt_ext::test_place_variance
