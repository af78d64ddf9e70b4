#include "mrpt_ext/evaluation/method_comparison.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_method_comparison
{
namespace
{
/// Squared errors that hang together over about ten samples.
std::vector<double> correlatedSquares(std::size_t count, double scale, RandomStream& random)
{
  std::vector<double> squares;
  double error = random.gaussian();
  for (std::size_t i = 0; i < count; ++i)
  {
    error = 0.9 * error + std::sqrt(1 - 0.81) * random.gaussian();
    squares.push_back(mrpt_ext::square(scale * error));
  }
  return squares;
}

MethodScore methodScore(const std::string& name, double scale, double ms)
{
  MethodScore score;
  score.name = name;
  score.continuous = true;
  score.step_ms_median = ms;
  for (int k = 0; k < 200; ++k) score.errors.push_back({100.0 + k, 100.0 + k, scale * (1 + 0.5 * std::sin(k)), {}});
  return score;
}
}  // namespace

TEST(MethodComparison, TheIntervalHoldsTheTrueRatio)
{
  RandomStream random(3);
  int inside = 0;
  constexpr int kTimes = 200;
  for (int k = 0; k < kTimes; ++k)
  {
    const auto ratio = rmseRatio(correlatedSquares(400, 1.2, random), correlatedSquares(400, 1.0, random), 20);
    ASSERT_TRUE(ratio);
    inside += ratio->low <= 1.2 && 1.2 <= ratio->high ? 1 : 0;
  }
  // Nominally 190; block bootstrap of so few blocks is known to be somewhat narrow.
  EXPECT_GT(inside, 165);
  EXPECT_LT(inside, kTimes);
}

TEST(MethodComparison, NeedsEnoughSamples)
{
  EXPECT_FALSE(rmseRatio({1, 2, 3, 4}, {1, 2, 3, 4}, 1));
  EXPECT_FALSE(rmseRatio(std::vector<double>(49, 1.0), std::vector<double>(49, 1.0), 10));
  EXPECT_FALSE(rmseRatio({1, 2, 3, 4, 5, 6}, {1, 2, 3, 4, 5}, 1));
}

TEST(MethodComparison, ComparesMethodsThatTrackFromConvergenceOn)
{
  RunScore score;
  score.judged_method = "particle_filter";
  score.methods = {methodScore("particle_filter", 0.1, 2), methodScore("extended_kalman_filter", 0.11, 0.01),
                   methodScore("odometry", 1, 0.001), methodScore("closed_form", 1, 0.1),
                   methodScore("oracle_of_it", 1, 0.1)};
  score.methods[3].continuous = false;
  score.methods[4].oracle = true;
  score.methods[1].errors[3].position_m = 100;  // before convergence
  const auto comparisons = compareMethods(score, 110);
  ASSERT_EQ(comparisons.size(), 1u);
  EXPECT_EQ(comparisons[0].method, "extended_kalman_filter");
  EXPECT_EQ(comparisons[0].reference, "particle_filter");
  EXPECT_NEAR(comparisons[0].rmse_ratio, 1.1, 1e-9);
  EXPECT_NEAR(*comparisons[0].cost_ratio, 0.005, 1e-12);
}

TEST(MethodComparison, OverTrialsEachTrialIsOnePair)
{
  std::vector<RunScore> trials;
  for (int k = 0; k < 10; ++k)
  {
    RunScore trial;
    trial.methods = {methodScore("particle_filter", 0, 2), methodScore("kalman_filter_bank", 0, 4)};
    trial.methods[0].position_error_m.rmse = 0.1 + 0.01 * k;
    if (k > 0) trial.methods[1].position_error_m.rmse = 0.2 + 0.02 * k;
    trials.push_back(trial);
  }
  RunScore merged = trials.front();
  merged.judged_method = "particle_filter";
  const auto comparisons = compareMethods(merged, trials);
  ASSERT_EQ(comparisons.size(), 1u);
  EXPECT_NEAR(comparisons[0].rmse_ratio, 2, 1e-9);
  EXPECT_NEAR(comparisons[0].ratio_low, 2, 1e-9);
}
}  // namespace mrpt_ext::test_method_comparison
