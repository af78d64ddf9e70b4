#include "mrpt_ext/filter/particles/simd_random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mrpt_ext::test_simd_random
{
namespace
{
std::vector<float> gaussians(std::uint64_t seed, std::uint64_t block, std::size_t count)
{
  std::vector<float> values(count);
  SimdRandom(seed, block).fillGaussians(values);
  return values;
}

double correlation(const std::vector<float>& a, const std::vector<float>& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += double{a[i]} * double{b[i]};
  return sum / static_cast<double>(a.size());
}
}  // namespace

TEST(SimdRandom, GaussiansHaveTheirMomentsAndTails)
{
  constexpr std::size_t kCount = 1 << 20;
  double power[5] = {};
  std::size_t beyond_3 = 0;
  for (const float v : gaussians(1, 0, kCount))
  {
    for (int k = 1; k <= 4; ++k) power[k] += std::pow(double{v}, k) / kCount;
    beyond_3 += std::abs(v) > 3 ? 1 : 0;
    ASSERT_LT(std::abs(v), 5.95F);
  }
  // Four standard errors of each moment.
  EXPECT_NEAR(power[1], 0, 4 * 1 / 1024.0);
  EXPECT_NEAR(power[2], 1, 4 * std::sqrt(2.0) / 1024);
  EXPECT_NEAR(power[3], 0, 4 * std::sqrt(15.0) / 1024);
  EXPECT_NEAR(power[4], 3, 4 * std::sqrt(96.0) / 1024);
  EXPECT_NEAR(static_cast<double>(beyond_3) / kCount, 0.0026998, 4 * std::sqrt(0.0027 / kCount));
}

TEST(SimdRandom, SeedsBlocksAndCallsGiveNumbersOfTheirOwn)
{
  constexpr std::size_t kCount = 1 << 16;
  const std::vector<float> first = gaussians(1, 0, kCount);
  EXPECT_EQ(first, gaussians(1, 0, kCount));
  EXPECT_NEAR(correlation(first, gaussians(1, 1, kCount)), 0, 4.0 / 256);
  EXPECT_NEAR(correlation(first, gaussians(2, 0, kCount)), 0, 4.0 / 256);
  SimdRandom lanes(1, 0);
  std::vector<float> again(kCount);
  for (int call = 0; call < 2; ++call) lanes.fillGaussians(again);
  EXPECT_NEAR(correlation(first, again), 0, 4.0 / 256);
}
}  // namespace mrpt_ext::test_simd_random
