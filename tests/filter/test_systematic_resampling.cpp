#include "mrpt_ext/filter/particles/systematic_resampling.h"

#include <gtest/gtest.h>

#include <numeric>

namespace mrpt_ext::test_systematic_resampling
{
namespace
{
struct Drawn
{
  ParticleSet particles;
  std::vector<int> mode_of;
};

/// Particle i at x = i; of mode 0 below 300, of mode 1 from there on.
Drawn twoModes(std::size_t count)
{
  RandomStream random(7);
  Drawn drawn;
  for (std::size_t i = 0; i < count; ++i)
  {
    drawn.particles.add({static_cast<double>(i), 0, 0}, std::log(0.1 + random.uniform()));
    drawn.mode_of.push_back(i < 300 ? 0 : 1);
  }
  normalizeWeights(drawn.particles);
  return drawn;
}

double weightOf(const ParticleSet& particles, double below)
{
  double sum = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (double{particles.x[i]} < below) sum += std::exp(double{particles.log_weight[i]});
  return sum;
}
}  // namespace

TEST(SystematicResampling, EveryParticleGetsItsExpectedNumberRoundedUpOrDown)
{
  const Drawn drawn = twoModes(1000);
  const std::size_t count = 3000;
  RandomStream random(1);
  const auto result = resampleSystematically(drawn.particles, drawn.mode_of, count, random, 1);
  ASSERT_TRUE(result);
  ASSERT_EQ(result->size(), count);
  std::vector<int> copies(1000, 0);
  for (const float x : result->x) ++copies[static_cast<std::size_t>(x)];
  // Within its mode, whose number of survivors is rounded too: hence a little more than one off.
  for (std::size_t i = 0; i < copies.size(); ++i)
    EXPECT_NEAR(copies[i], static_cast<double>(count) * std::exp(double{drawn.particles.log_weight[i]}), 1.1);
}

TEST(SystematicResampling, ModesKeepTheirWeightToTheLastDigit)
{
  const Drawn drawn = twoModes(1000);
  for (const std::size_t count : {50U, 333U, 2000U})
  {
    RandomStream random(count);
    const auto result = resampleSystematically(drawn.particles, drawn.mode_of, count, random, 1);
    ASSERT_TRUE(result);
    EXPECT_NEAR(weightOf(*result, 300), weightOf(drawn.particles, 300), 1e-5);
    EXPECT_NEAR(weightOf(*result, 1e9), 1, 1e-5);
  }
}

TEST(SystematicResampling, TheResultDoesNotDependOnTheNumberOfThreads)
{
  const Drawn drawn = twoModes(40000);
  RandomStream first(3), second(3);
  const auto one = resampleSystematically(drawn.particles, drawn.mode_of, 30000, first, 1);
  const auto four = resampleSystematically(drawn.particles, drawn.mode_of, 30000, second, 4);
  ASSERT_TRUE(one && four);
  EXPECT_EQ(one->x, four->x);
  EXPECT_EQ(one->log_weight, four->log_weight);
}

TEST(SystematicResampling, OneParticleWithAllTheWeightIsCopiedToEveryIndex)
{
  Drawn drawn = twoModes(5000);
  std::fill(drawn.particles.log_weight.begin(), drawn.particles.log_weight.end(), -1e6F);
  drawn.particles.log_weight[4000] = 0;
  RandomStream random(5);
  const auto result = resampleSystematically(drawn.particles, drawn.mode_of, 20001, random, 2);
  ASSERT_TRUE(result);
  for (const float x : result->x) ASSERT_EQ(x, 4000.0F);
  EXPECT_NEAR(weightOf(*result, 1e9), 1, 1e-3);
}

TEST(SystematicResampling, TheResultDoesNotDependOnTheContentOfTheBuffer)
{
  const Drawn drawn = twoModes(3000);
  ParticleSet used(Vector2d(7, 7), {{.kind = BiasKind::distance_scale}});
  for (int i = 0; i < 5000; ++i) used.add({1, 2, 3}, 4);
  RandomStream first(3), second(3);
  const auto fresh = resampleSystematically(drawn.particles, drawn.mode_of, 2000, first, 1);
  const auto reused = resampleSystematically(drawn.particles, drawn.mode_of, 2000, second, 1, std::move(used));
  ASSERT_TRUE(fresh && reused);
  EXPECT_EQ(fresh->origin, reused->origin);
  EXPECT_EQ(fresh->bias.size(), reused->bias.size());
  EXPECT_EQ(fresh->x, reused->x);
  EXPECT_EQ(fresh->y, reused->y);
  EXPECT_EQ(fresh->phi, reused->phi);
  EXPECT_EQ(fresh->log_weight, reused->log_weight);
}

TEST(SystematicResampling, ReturnsNothingWithoutWeightOrCount)
{
  const Drawn drawn = twoModes(1000);
  RandomStream random(1);
  EXPECT_FALSE(resampleSystematically(drawn.particles, drawn.mode_of, 0, random, 1));
  ParticleSet weightless = drawn.particles;
  std::fill(weightless.log_weight.begin(), weightless.log_weight.end(), -1e6F);
  EXPECT_FALSE(resampleSystematically(weightless, drawn.mode_of, 10, random, 1));
}
}  // namespace mrpt_ext::test_systematic_resampling
