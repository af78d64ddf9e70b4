#include "mrpt_ext/geometry/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace mrpt_ext::test_random
{
namespace
{
constexpr int kDraws = 400000;

double correlation(RandomStream a, RandomStream b)
{
  double sum = 0;
  for (int i = 0; i < kDraws; ++i) sum += a.gaussian() * b.gaussian();
  return sum / kDraws;
}
}  // namespace

TEST(RandomStream, SameSeedAndStreamGiveTheSameNumbers)
{
  RandomStream a(7, 3), b(7, 3);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(a.gaussian(), b.gaussian());
}

TEST(RandomStream, FirstNumbersNeverChange)
{
  RandomStream bits(42, 7);  // expected: the published algorithms, evaluated independently with whole numbers
  EXPECT_EQ(bits.nextBits(), 0x554651e47226193fULL);
  EXPECT_EQ(bits.nextBits(), 0x5b59259989b7a57eULL);
  EXPECT_EQ(bits.nextBits(), 0x38d056b5824b4848ULL);
  RandomStream gaussians(42, 7);
  EXPECT_NEAR(gaussians.gaussian(), -0.51627825482951173, 1e-12);
  EXPECT_NEAR(gaussians.gaussian(), -0.10390531437944131, 1e-12);
  EXPECT_NEAR(gaussians.gaussian(), -0.79264209349167281, 1e-12);
}

TEST(RandomStream, UniformIsInRangeWithTheRightMoments)
{
  RandomStream random(1);
  double sum = 0, sum_of_squares = 0;
  for (int i = 0; i < kDraws; ++i)
  {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    sum_of_squares += u * u;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 0.003);
  EXPECT_NEAR(sum_of_squares / kDraws, 1.0 / 3.0, 0.003);
}

TEST(RandomStream, GaussianHasTheRightMoments)
{
  RandomStream random(2);
  double m1 = 0, m2 = 0, m3 = 0, m4 = 0;
  for (int i = 0; i < kDraws; ++i)
  {
    const double g = random.gaussian();
    m1 += g;
    m2 += g * g;
    m3 += g * g * g;
    m4 += g * g * g * g;
  }
  EXPECT_NEAR(m1 / kDraws, 0.0, 0.008);
  EXPECT_NEAR(m2 / kDraws, 1.0, 0.012);
  EXPECT_NEAR(m3 / kDraws, 0.0, 0.03);
  EXPECT_NEAR(m4 / kDraws, 3.0, 0.08);
}

/// Kolmogorov-Smirnov distance to the normal distribution; 1.95 / sqrt(n) is exceeded once in a thousand seeds.
TEST(RandomStream, GaussianFollowsTheNormalDistribution)
{
  RandomStream random(3);
  std::vector<double> draws(kDraws);
  std::generate(draws.begin(), draws.end(), [&] { return random.gaussian(); });
  std::sort(draws.begin(), draws.end());
  double distance = 0;
  for (int i = 0; i < kDraws; ++i)
    distance = std::max(distance, std::abs((i + 0.5) / kDraws - 0.5 * std::erfc(-draws[i] / std::sqrt(2.0))));
  EXPECT_LT(distance, 1.95 / std::sqrt(double{kDraws}));
}

TEST(RandomStream, GaussianTailsHaveTheRightWeight)
{
  RandomStream random(4);
  int beyond_two = 0, beyond_tail_start = 0;
  for (int i = 0; i < 4 * kDraws; ++i)
  {
    const double g = std::abs(random.gaussian());
    beyond_two += g > 2;
    beyond_tail_start += g > 3.5;
  }
  EXPECT_NEAR(beyond_two / (4.0 * kDraws), std::erfc(2 / std::sqrt(2.0)), 8e-4);
  EXPECT_NEAR(beyond_tail_start / (4.0 * kDraws), std::erfc(3.5 / std::sqrt(2.0)), 8e-5);
}

TEST(RandomStream, StreamsAndSeedsAreIndependent)
{
  EXPECT_NEAR(correlation(RandomStream(5, 0), RandomStream(5, 1)), 0, 0.008);
  EXPECT_NEAR(correlation(RandomStream(5, 0), RandomStream(6, 0)), 0, 0.008);
  EXPECT_NEAR(correlation(RandomStream(5, 1), RandomStream(6, 0)), 0, 0.008);
}

TEST(RandomStream, BelowIsUniformAndInRange)
{
  RandomStream random(8);
  std::vector<int> counts(7);
  for (int i = 0; i < 70000; ++i) ++counts.at(random.below(7));
  for (const int count : counts) EXPECT_NEAR(count, 10000, 400);
  EXPECT_EQ(random.below(0), 0U);
  EXPECT_EQ(random.below(1), 0U);
}

TEST(RandomStream, PoissonHasItsMeanAsVariance)
{
  for (const double mean : {0.3, 4.0, 75.0})
  {
    RandomStream random(9);
    double sum = 0, sum_of_squares = 0;
    constexpr int kCounts = 40000;
    for (int i = 0; i < kCounts; ++i)
    {
      const int events = random.poisson(mean);
      sum += events;
      sum_of_squares += double{1} * events * events;
    }
    const double average = sum / kCounts;
    EXPECT_NEAR(average, mean, 4 * std::sqrt(mean / kCounts));
    EXPECT_NEAR(sum_of_squares / kCounts - average * average, mean, 0.04 * mean + 0.01);
  }
  EXPECT_EQ(RandomStream(1).poisson(0), 0);
}
}  // namespace mrpt_ext::test_random
