#include "mrpt_ext/likelihood/compass_likelihood.h"

#include <gtest/gtest.h>

#include <vector>

namespace mrpt_ext::test_compass_likelihood
{
namespace
{
double density(double heading, double std, double phi)
{
  PoseColumns robot;
  robot.add({0, 0, phi});
  float log_likelihood = 0;
  addCompassLogLikelihood({.heading = heading, .std_heading = std}, robot.batch(), {&log_likelihood, 1});
  return std::exp(double{log_likelihood});
}
}  // namespace

TEST(CompassLikelihood, IsNormalisedOverTheMeasuredHeading)
{
  const int n = 20000;
  for (const double std : {0.01, 0.1, 0.5})
    for (const double phi : {-3.1, 0.4, 3.1})
    {
      double sum = 0;
      for (int i = 0; i < n; ++i) sum += density(-kPi + (i + 0.5) * kTwoPi / n, std, phi);
      EXPECT_NEAR(sum * kTwoPi / n, 1, 1e-6) << std << " " << phi;
    }
}

TEST(CompassLikelihood, ResidualsWrap)
{
  EXPECT_NEAR(density(kPi - 0.02, 0.1, -kPi + 0.03), density(0.0, 0.1, 0.05), 1e-5);
}

TEST(CompassLikelihood, AWrongCompassCannotRuleAPoseOut) { EXPECT_NEAR(density(3.0, 0.001, 0.0), 0.05 / kTwoPi, 1e-8); }

TEST(CompassLikelihood, AddsToWhatIsThere)
{
  PoseColumns robots;
  for (const double phi : {0.0, 0.5}) robots.add({0, 0, phi});
  std::vector<float> log_likelihood{-1, -2};
  addCompassLogLikelihood({.heading = 0.0, .std_heading = 0.1}, robots.batch(), log_likelihood);
  EXPECT_NEAR(log_likelihood[0], -1.0 + std::log(density(0.0, 0.1, 0.0)), 1e-6);
  EXPECT_NEAR(log_likelihood[1], -2.0 + std::log(density(0.0, 0.1, 0.5)), 1e-6);
}
}  // namespace mrpt_ext::test_compass_likelihood
