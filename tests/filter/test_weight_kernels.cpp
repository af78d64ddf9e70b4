#include "mrpt_ext/filter/particles/weight_kernels.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_weight_kernels
{
namespace
{
/// Lengths about the lanes and chunks that the kernels work in.
constexpr std::size_t kLengths[] = {1, 15, 16, 17, 31, 1023, 1024, 1025, 5000};

std::vector<float> logWeights(std::size_t count)
{
  RandomStream random(count);
  std::vector<float> values(count);
  for (float& value : values) value = static_cast<float>(-20 * random.uniform());
  return values;
}
}  // namespace

RC_GTEST_PROP(WeightKernels, LargestIsThatOfTheStandardLibrary, (const std::vector<float>& values))
{
  const auto largest = std::max_element(values.begin(), values.end());
  RC_ASSERT(largestOf(values) == (values.empty() ? -std::numeric_limits<float>::infinity() : *largest));
}

TEST(WeightKernels, ExponentialsAndTheirSum)
{
  for (const std::size_t count : kLengths)
  {
    const std::vector<float> logs = logWeights(count);
    std::vector<float> weights(count);
    const double sum = exponentials(logs, -3, weights);
    double expected = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double exact = std::exp(double{logs[i]} + 3);
      expected += exact;
      EXPECT_NEAR(double{weights[i]}, exact, 1e-6 * exact);
    }
    EXPECT_NEAR(sum, expected, 1e-5 * expected) << count;
  }
}

TEST(WeightKernels, SumsOfWeightsAndSquares)
{
  for (const std::size_t count : kLengths)
  {
    const std::vector<float> logs = logWeights(count);
    double first = 0, second = 0;
    for (const float log_w : logs)
    {
      first += std::exp(double{log_w});
      second += std::exp(2 * double{log_w});
    }
    const WeightSums sums = weightSums(logs, 0);
    EXPECT_NEAR(sums.first, first, 1e-5 * first) << count;
    EXPECT_NEAR(sums.second, second, 1e-5 * second) << count;
  }
}

TEST(WeightKernels, WeightsThatUnderflowAreZero)
{
  const std::vector<float> logs{0, -90, -std::numeric_limits<float>::infinity()};
  std::vector<float> weights(3);
  EXPECT_FLOAT_EQ(static_cast<float>(exponentials(logs, 0, weights)), 1.0F);
  EXPECT_EQ(weights[1], 0.0F);
  EXPECT_EQ(weights[2], 0.0F);
}

TEST(WeightKernels, SubtractsBothOneAfterTheOther)
{
  std::vector<float> values{1.0F, 2.5F};
  subtractAll(values, 0.5F, 0.25F);
  EXPECT_EQ(values, (std::vector<float>{0.25F, 1.75F}));
}
}  // namespace mrpt_ext::test_weight_kernels
