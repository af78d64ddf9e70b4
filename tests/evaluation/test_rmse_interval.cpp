#include "mrpt_ext/evaluation/rmse_interval.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_rmse_interval
{
namespace
{
std::vector<ErrorSample> independentErrors(RandomStream& random, int count)
{
  std::vector<ErrorSample> errors;
  for (int i = 0; i < count; ++i)
    errors.push_back({i * 1.0, i * 1.0, std::hypot(random.gaussian(), random.gaussian()), {}});
  return errors;
}
}  // namespace

/// The RMSE of two unit Gaussians is sqrt(2); 95 % of the intervals should hold it, fewer do with few blocks.
TEST(RmseInterval, HasItsNominalCoverage)
{
  RandomStream random(7);
  int held = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    const auto interval = rmseInterval(independentErrors(random, 400), 0);
    ASSERT_TRUE(interval);
    held += interval->low <= std::sqrt(2.0) && std::sqrt(2.0) <= interval->high ? 1 : 0;
  }
  EXPECT_GE(held, 176);  // 88 %
  EXPECT_LE(held, 199);
}

TEST(RmseInterval, CountsFromTheGivenTime)
{
  RandomStream random(7);
  std::vector<ErrorSample> errors = independentErrors(random, 200);
  for (int i = 0; i < 100; ++i) errors[static_cast<std::size_t>(i)].position_m = 1000;
  EXPECT_LT(rmseInterval(errors, 100)->high, 3);
}

TEST(RmseInterval, OfTooFewIsNone)
{
  RandomStream random(7);
  EXPECT_FALSE(rmseInterval(independentErrors(random, 49), 0));
  EXPECT_TRUE(rmseInterval(independentErrors(random, 50), 0));
}

TEST(MedianInterval, ContainsTheMedian)
{
  std::vector<double> values;
  for (int i = 1; i <= 25; ++i) values.push_back(i);
  const auto interval = medianInterval(values);
  ASSERT_TRUE(interval);
  EXPECT_GE(interval->low, 7);
  EXPECT_LT(interval->low, 13);
  EXPECT_GT(interval->high, 13);
  EXPECT_LE(interval->high, 19);
  EXPECT_FALSE(medianInterval({1, 2, 3, 4}));
}
}  // namespace mrpt_ext::test_rmse_interval
