#include "mrpt_ext/geometry/vector_math.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext::vector_math::test_vector_math
{
namespace
{
/// Largest error of `approximate` over `n` points from low to high, as `error` measures it.
template <class Approximate, class Exact, class Error>
double largestError(double low, double high, int n, const Approximate& approximate, const Exact& exact,
                    const Error& error)
{
  double largest = 0;
  for (int i = 0; i <= n; ++i)
  {
    const float x = static_cast<float>(low + (high - low) * i / n);
    largest = std::max(largest, error(double{approximate(x)}, exact(double{x})));
  }
  return largest;
}

// The functions are always inlined: they have no address that a compiler which does not optimize could hand over.
const auto kPowerOfTwo = [](float x) { return exp2Of(x); };
const auto kExponential = [](float x) { return expOf(x); };
const auto kLogarithm = [](float x) { return logOf(x); };
const auto kSquaredAngle = [](float x) { return squaredAngleOf(x); };

const auto kRelative = [](double a, double b) { return std::abs(a - b) / std::abs(b); };
const auto kAbsolute = [](double a, double b) { return std::abs(a - b); };
}  // namespace

TEST(VectorMath, PowersOfTwo)
{
  EXPECT_LT(largestError(
                -126, 127, 300007, kPowerOfTwo, [](double x) { return std::exp2(x); }, kRelative),
            2e-7);
  EXPECT_LT(largestError(
                -1, 1, 300007, kPowerOfTwo, [](double x) { return std::exp2(x); }, kRelative),
            2e-7);
  EXPECT_EQ(exp2Of(-500), std::exp2(-126.0F));
  EXPECT_EQ(exp2Of(-1e30F), std::exp2(-126.0F));
}

TEST(VectorMath, Exponential)
{
  const auto error = [](double a, double b) { return std::abs(a - b) / b / (2e-7 + 1e-7 * std::abs(std::log(b))); };
  EXPECT_LT(largestError(
                -87, 88, 300007, kExponential, [](double x) { return std::exp(x); }, error),
            1);
}

TEST(VectorMath, Logarithm)
{
  const auto error = [](double a, double b) { return std::abs(a - b) / std::max(std::abs(b), 1e-7); };
  const auto exact = [](double x) { return std::log(x); };
  EXPECT_LT(largestError(0.3, 3, 1000003, kLogarithm, exact, error), 3e-7);
  for (int e = -126; e < 127; ++e)
    EXPECT_LT(largestError(std::exp2(e), std::exp2(e + 1), 1009, kLogarithm, exact, error), 3e-7) << e;
}

TEST(VectorMath, SineAndCosine)
{
  const auto sine = [](float x) { return sineCosineOf(x).sine; };
  const auto cosine = [](float x) { return sineCosineOf(x).cosine; };
  for (const double reach : {3.2, 1000.0})
  {
    EXPECT_LT(largestError(
                  -reach, reach, 1000003, sine, [](double x) { return std::sin(x); }, kAbsolute),
              1e-7);
    EXPECT_LT(largestError(
                  -reach, reach, 1000003, cosine, [](double x) { return std::cos(x); }, kAbsolute),
              1e-7);
  }
}

TEST(VectorMath, AngleOfAVector)
{
  double largest = 0;
  for (int i = 0; i < 200000; ++i)
  {
    const double angle = -kPi + kTwoPi * (i + 0.5) / 200000, length = std::exp2(i % 40 - 20);
    const float y = static_cast<float>(length * std::sin(angle)), x = static_cast<float>(length * std::cos(angle));
    largest = std::max(largest, std::abs(wrap(double{angleOf(y, x)} - std::atan2(double{y}, double{x}))));
  }
  EXPECT_LT(largest, 3e-7);
  EXPECT_EQ(angleOf(0, 0), 0);
  EXPECT_EQ(angleOf(0, 1), 0);
  EXPECT_EQ(angleOf(0, -2), static_cast<float>(kPi));
}

TEST(VectorMath, SquaredAngleFromSquaredSine)
{
  const auto exact = [](double f) { return square(std::asin(std::sqrt(f))); };
  EXPECT_LT(largestError(1e-12, 0.25, 1000003, kSquaredAngle, exact, kRelative), 4e-7);
  for (double f = 0.25, before = 0; f <= 1; f += 0.01)
  {
    const double angle2 = squaredAngleOf(static_cast<float>(f));
    EXPECT_GT(angle2, before);
    EXPECT_LE(std::sqrt(angle2), kPi / 2);
    before = angle2;
  }
  EXPECT_EQ(squaredAngleOf(0), 0);
}
}  // namespace mrpt_ext::vector_math::test_vector_math
