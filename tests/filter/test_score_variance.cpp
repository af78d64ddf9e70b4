#include "mrpt_ext/filter/consider/score_variance.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_score_variance
{
namespace
{
constexpr double kPeriod = 0.1;  // [s]

/// Readings of a constant for an hour, whose errors have a part that stays the same for `lasting` readings.
double worthOf(int lasting, double share, std::uint64_t seed)
{
  RandomStream random(seed, 1);
  ScoreVariance variance;
  double constant = 0;
  for (int i = 0; i < 36'000; ++i)
  {
    if (i % lasting == 0) constant = random.gaussian();
    const double error = std::sqrt(share) * constant + std::sqrt(1 - share) * random.gaussian();
    variance.add(kPeriod, Eigen::VectorXd::Constant(1, error), Eigen::VectorXd::Ones(1), 1);
  }
  return variance.worth(1)[0];
}

TEST(ScoreVariance, IsOneBeforeAnythingIsKnown)
{
  ScoreVariance variance;
  variance.add(kPeriod, Eigen::Vector2d(3, -4), Eigen::Vector2d(1, 1), 1);
  EXPECT_EQ(variance.worth(3), Eigen::Vector3d::Ones());
}

TEST(ScoreVariance, WhiteErrorsAreWorthTheirInformation) { EXPECT_GT(worthOf(1, 0, 2), 0.85); }

TEST(ScoreVariance, ErrorsThatLastAreWorthTheNumberOfIndependentOnes)
{
  // Fifty at a time are like one: in a block of a hundred the score has a variance of 50 * 100 instead of 100.
  EXPECT_NEAR(worthOf(50, 1, 3), 1.0 / 50, 0.5 / 50);
  // ... and with half of the variance white: 0.5 * 50 + 0.5.
  EXPECT_NEAR(worthOf(50, 0.5, 4), 1.0 / 25.5, 0.5 / 25.5);
}
}  // namespace
}  // namespace mrpt_ext::test_score_variance
