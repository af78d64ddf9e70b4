#include "mrpt_ext/filter/particle_set.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <numeric>

namespace mrpt_ext
{
namespace
{
ParticleSet withLogWeights(const std::vector<double>& log_weights)
{
  ParticleSet particles;
  for (const double log_w : log_weights) particles.add({1, 2, 3}, log_w);
  return particles;
}

double weightSum(const ParticleSet& particles)
{
  const std::vector<double> w = weights(particles);
  return std::accumulate(w.begin(), w.end(), 0.0);
}
}  // namespace

TEST(ParticleSet, NormalisationReturnsTheLogarithmOfTheSum)
{
  ParticleSet particles = withLogWeights({std::log(1.0), std::log(2.0), std::log(5.0)});
  EXPECT_NEAR(normalizeWeights(particles), std::log(8.0), 1e-12);
  const std::vector<double> w = weights(particles);
  EXPECT_NEAR(w[0], 0.125, 1e-12);
  EXPECT_NEAR(w[1], 0.25, 1e-12);
  EXPECT_NEAR(w[2], 0.625, 1e-12);
  EXPECT_NEAR(normalizeWeights(particles), 0, 1e-12);
}

TEST(ParticleSet, VeryUnlikelyParticlesAreNormalisedWithoutUnderflow)
{
  ParticleSet particles = withLogWeights({-1e6, -1e6 + std::log(3.0), -2e6});
  EXPECT_NEAR(normalizeWeights(particles), -1e6 + std::log(4.0), 1e-6);
  const std::vector<double> w = weights(particles);
  EXPECT_NEAR(w[0], 0.25, 1e-9);
  EXPECT_NEAR(w[1], 0.75, 1e-9);
  EXPECT_EQ(w[2], 0);
  for (const double log_w : particles.log_weight) EXPECT_TRUE(std::isfinite(log_w));
}

TEST(ParticleSet, WhenNoParticleIsPossibleAllCountTheSame)
{
  ParticleSet particles = withLogWeights(std::vector<double>(4, -std::numeric_limits<double>::infinity()));
  normalizeWeights(particles);
  for (const double w : weights(particles)) EXPECT_NEAR(w, 0.25, 1e-12);
}

RC_GTEST_PROP(ParticleSet, WeightsSumToOne, (const std::vector<int>& millionths))
{
  RC_PRE(!millionths.empty());
  std::vector<double> log_weights;
  for (const int v : millionths) log_weights.push_back(1e-3 * v);
  ParticleSet particles = withLogWeights(log_weights);
  normalizeWeights(particles);
  RC_ASSERT(std::abs(weightSum(particles) - 1) < 1e-9);
  const double ratio = effectiveSampleRatio(particles), n = static_cast<double>(particles.size());
  RC_ASSERT(ratio <= 1 + 1e-9 && ratio >= 1 / n - 1e-9);
}

TEST(ParticleSet, EffectiveRatioOfEqualAndOfOneHotWeights)
{
  ParticleSet equal = withLogWeights(std::vector<double>(50, -7.0));
  normalizeWeights(equal);
  EXPECT_NEAR(effectiveSampleRatio(equal), 1, 1e-12);
  ParticleSet one_hot = withLogWeights(std::vector<double>(50, -1e5));
  one_hot.log_weight[17] = 0;
  normalizeWeights(one_hot);
  EXPECT_NEAR(effectiveSampleRatio(one_hot), 1.0 / 50, 1e-12);
  ParticleSet half = withLogWeights({0, 0, -1e5, -1e5});
  normalizeWeights(half);
  EXPECT_NEAR(effectiveSampleRatio(half), 0.5, 1e-12);
}

TEST(ParticleSet, EmptyIsAValue)
{
  ParticleSet none;
  EXPECT_EQ(normalizeWeights(none), 0);
  EXPECT_EQ(effectiveSampleRatio(none), 0);
  EXPECT_TRUE(weights(none).empty());
  EXPECT_TRUE(select(none, {}).empty());
}

TEST(ParticleSet, SelectionGivesEqualWeights)
{
  ParticleSet particles;
  for (int i = 0; i < 5; ++i) particles.add({1.0 * i, 10.0 * i, 0.1 * i}, -i);
  const ParticleSet chosen = select(particles, {4, 4, 1});
  ASSERT_EQ(chosen.size(), 3u);
  EXPECT_EQ(chosen.x[0], 4);
  EXPECT_EQ(chosen.y[1], 40);
  EXPECT_EQ(chosen.phi[2], 0.1);
  for (const double w : weights(chosen)) EXPECT_NEAR(w, 1.0 / 3, 1e-12);
}
}  // namespace mrpt_ext
