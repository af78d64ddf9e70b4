#include "mrpt_ext/evaluation/convergence.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_convergence
{
namespace
{
/// One sample per second from 0, with these position errors.
std::vector<ErrorSample> everySecond(const std::vector<double>& errors)
{
  std::vector<ErrorSample> samples;
  for (const double error : errors)
  {
    const auto t = static_cast<double>(samples.size());
    samples.push_back({t, t, error, {}});
  }
  return samples;
}

std::vector<double> withOutsideFrom(int first, int count)
{
  std::vector<double> errors(60, 0.1);
  for (int i = 0; i < count; ++i) errors[static_cast<std::size_t>(first + i)] = 2.0;
  return errors;
}

const ConvergenceLimits kLimits;
}  // namespace

TEST(Convergence, IsTheStartOfTheFirstFiveSecondsWithinTheLimits)
{
  EXPECT_EQ(convergenceStamp(everySecond({9, 9, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1}), kLimits), 2.0);
  // Only four seconds within the limits: it has to begin anew.
  EXPECT_EQ(convergenceStamp(everySecond({0.1, 0.1, 0.1, 0.1, 0.1, 9, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1}), kLimits), 6.0);
}

TEST(Convergence, NeverWhenTheLogEndsTooEarly)
{
  EXPECT_FALSE(convergenceStamp(everySecond({9, 0.1, 0.1, 0.1, 0.1, 0.1}), kLimits));
  EXPECT_FALSE(convergenceStamp(everySecond({9, 9, 9, 9, 9, 9, 9, 9}), kLimits));
  EXPECT_FALSE(convergenceStamp({}, kLimits));
}

TEST(Convergence, HeadingCountsWhereItIsKnown)
{
  auto errors = everySecond(std::vector<double>(8, 0.1));
  errors[1].heading_deg = 20;
  EXPECT_EQ(convergenceStamp(errors, kLimits), 2.0);
  errors[1].heading_deg = 15;
  EXPECT_EQ(convergenceStamp(errors, kLimits), 0.0);
}

TEST(Convergence, AGapOfTheTruthIsNoConvergence)
{
  auto errors = everySecond({0.1, 0.1, 0.1});
  errors.push_back({30, 30, 9, {}});
  EXPECT_FALSE(convergenceStamp(errors, kLimits));
  errors.back().position_m = 0.1;
  EXPECT_EQ(convergenceStamp(errors, kLimits), 0.0);
}

TEST(Success, ElevenSecondsOutsideIsAFailure)
{
  EXPECT_TRUE(isSuccess(everySecond(withOutsideFrom(20, 10)), 0, kLimits));
  EXPECT_FALSE(isSuccess(everySecond(withOutsideFrom(20, 11)), 0, kLimits));
  EXPECT_FALSE(isSuccess(everySecond(withOutsideFrom(49, 11)), 0, kLimits));  // to the very end
  EXPECT_EQ(longestTimeOutside(everySecond(withOutsideFrom(20, 11)), 0, kLimits), 11);
  EXPECT_EQ(longestTimeOutside(everySecond(withOutsideFrom(20, 11)), 40, kLimits), 0);
}

TEST(Success, NeedsConvergenceInTime)
{
  std::vector<double> errors(120, 0.1);
  std::fill_n(errors.begin(), 60, 9.0);
  EXPECT_TRUE(isSuccess(everySecond(errors), 0, kLimits));
  errors[60] = 9;
  EXPECT_FALSE(isSuccess(everySecond(errors), 0, kLimits));
  EXPECT_TRUE(isSuccess(everySecond(errors), 1, kLimits));  // the log itself began a second later
}

TEST(Convergence, ATruthThatBeginsLateOrIsShortTellsNoSuccess)
{
  EXPECT_TRUE(tellsSuccess({10, 40, 90}, 0, kLimits));
  EXPECT_FALSE(tellsSuccess({61, 90}, 0, kLimits));
  EXPECT_FALSE(tellsSuccess({10, 14}, 0, kLimits));
  EXPECT_FALSE(tellsSuccess({}, 0, kLimits));
}
}  // namespace mrpt_ext::test_convergence
