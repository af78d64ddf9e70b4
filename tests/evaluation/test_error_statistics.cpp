#include "mrpt_ext/evaluation/error_statistics.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace mrpt_ext::test_error_statistics
{
TEST(ErrorStatistics, OfThreeNumbers)
{
  const ErrorStatistics s = errorStatistics({4, 1, 1});
  EXPECT_EQ(s.count, 3u);
  EXPECT_DOUBLE_EQ(*s.mean, 2);
  EXPECT_DOUBLE_EQ(*s.median, 1);
  EXPECT_DOUBLE_EQ(*s.rmse, std::sqrt(6.0));
  EXPECT_DOUBLE_EQ(*s.std, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(*s.min, 1);
  EXPECT_DOUBLE_EQ(*s.max, 4);
  EXPECT_DOUBLE_EQ(*s.p95, 1 + 0.9 * 3);  // position 0.95 * 2 = 1.9 between the second and the third
}

TEST(ErrorStatistics, EmptySampleHasNone)
{
  const ErrorStatistics s = errorStatistics({});
  EXPECT_EQ(s.count, 0u);
  for (const auto& figure : {s.rmse, s.mean, s.median, s.std, s.min, s.max, s.p95}) EXPECT_FALSE(figure);
}

TEST(ErrorStatistics, OneErrorHasNoSpread)
{
  const ErrorStatistics s = errorStatistics({0.3});
  for (const auto& figure : {s.rmse, s.mean, s.median, s.min, s.max, s.p95}) EXPECT_DOUBLE_EQ(*figure, 0.3);
  EXPECT_DOUBLE_EQ(*s.std, 0);
}

RC_GTEST_PROP(ErrorStatistics, AreOrderedAndConsistent, (const std::vector<int>& raw))
{
  RC_PRE(!raw.empty());
  std::vector<double> sample;
  for (const int v : raw) sample.push_back(std::abs(v % 1000) / 10.0);
  const ErrorStatistics s = errorStatistics(sample);
  RC_ASSERT(*s.min <= *s.median && *s.median <= *s.p95 && *s.p95 <= *s.max);
  RC_ASSERT(*s.mean <= *s.rmse + 1e-9);
  RC_ASSERT(std::abs(*s.rmse * *s.rmse - *s.mean * *s.mean - *s.std * *s.std) < 1e-6);
}
}  // namespace mrpt_ext::test_error_statistics
