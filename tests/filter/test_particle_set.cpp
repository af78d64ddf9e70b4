#include "mrpt_ext/filter/particles/particle_set.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <numeric>

namespace mrpt_ext::test_particle_set
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

double ratioOf(ParticleSet particles) { return normalizeWeights(particles).effective_ratio; }
}  // namespace

TEST(ParticleSet, NormalisationReturnsTheLogarithmOfTheSum)
{
  ParticleSet particles = withLogWeights({std::log(1.0), std::log(2.0), std::log(5.0)});
  EXPECT_NEAR(normalizeWeights(particles).log_sum, std::log(8.0), 1e-6);
  const std::vector<double> w = weights(particles);
  EXPECT_NEAR(w[0], 0.125, 1e-7);
  EXPECT_NEAR(w[1], 0.25, 1e-7);
  EXPECT_NEAR(w[2], 0.625, 1e-7);
  EXPECT_NEAR(normalizeWeights(particles).log_sum, 0, 1e-6);
}

TEST(ParticleSet, VeryUnlikelyParticlesAreNormalisedWithoutUnderflow)
{
  ParticleSet particles = withLogWeights({-1e4, -1e4 + std::log(3.0), -2e4});
  EXPECT_NEAR(normalizeWeights(particles).log_sum, -1e4 + std::log(4.0), 1e-3);
  const std::vector<double> w = weights(particles);
  EXPECT_NEAR(w[0], 0.25, 1e-3);
  EXPECT_NEAR(w[1], 0.75, 1e-3);
  EXPECT_EQ(w[2], 0);
  for (const float log_w : particles.log_weight) EXPECT_TRUE(std::isfinite(log_w));
}

TEST(ParticleSet, WhenNoParticleIsPossibleAllWeightsAreEqual)
{
  ParticleSet particles = withLogWeights(std::vector<double>(4, -std::numeric_limits<double>::infinity()));
  normalizeWeights(particles);
  for (const double w : weights(particles)) EXPECT_NEAR(w, 0.25, 1e-7);
}

RC_GTEST_PROP(ParticleSet, WeightsSumToOne, (const std::vector<int>& millionths))
{
  RC_PRE(!millionths.empty());
  std::vector<double> log_weights;
  for (const int v : millionths) log_weights.push_back(1e-3 * v);
  ParticleSet particles = withLogWeights(log_weights);
  normalizeWeights(particles);
  RC_ASSERT(std::abs(weightSum(particles) - 1) < 1e-6);
  const double ratio = ratioOf(particles), n = static_cast<double>(particles.size());
  RC_ASSERT(ratio <= 1 + 1e-6 && ratio >= 1 / n - 1e-6);
}

TEST(ParticleSet, EffectiveRatioOfEqualAndOfOneHotWeights)
{
  ParticleSet equal = withLogWeights(std::vector<double>(50, -7.0));
  normalizeWeights(equal);
  EXPECT_NEAR(ratioOf(equal), 1, 1e-6);
  ParticleSet one_hot = withLogWeights(std::vector<double>(50, -1e5));
  one_hot.log_weight[17] = 0;
  normalizeWeights(one_hot);
  EXPECT_NEAR(ratioOf(one_hot), 1.0 / 50, 1e-6);
  ParticleSet half = withLogWeights({0, 0, -1e5, -1e5});
  normalizeWeights(half);
  EXPECT_NEAR(ratioOf(half), 0.5, 1e-6);
}

TEST(ParticleSet, AnEmptySetIsValid)
{
  ParticleSet none;
  EXPECT_EQ(normalizeWeights(none).log_sum, 0);
  EXPECT_EQ(ratioOf(none), 0);
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
  EXPECT_EQ(chosen.phi[2], 0.1F);
  for (const double w : weights(chosen)) EXPECT_NEAR(w, 1.0 / 3, 1e-7);
}

TEST(ParticleSet, FarFromZeroPosesAreAsPreciseAsNearby)
{
  const Vector2d origin(5.3e5, 4.81e6);  // a national grid
  ParticleSet particles(origin);
  const Pose2 pose{origin.x() + 40.12345, origin.y() - 70.54321, -kPi};
  particles.add(pose, 0);
  EXPECT_NEAR(particles.pose(0).x, pose.x, 1e-5);
  EXPECT_NEAR(particles.pose(0).y, pose.y, 1e-5);
  EXPECT_NEAR(std::abs(particles.pose(0).phi), kPi, 1e-6);
  EXPECT_EQ(particles.pose(0).phi, wrap(particles.pose(0).phi));
  EXPECT_EQ(particles.poses()[0].vector(), particles.pose(0).vector());
}

TEST(ParticleSet, ParticlesKeepTheirSystematicErrors)
{
  ParticleSet particles({1, 1}, {{.kind = BiasKind::range_offset, .mean = 0.5}, {.kind = BiasKind::distance_scale}});
  for (int i = 0; i < 3; ++i) particles.add({0, 0, 0}, 0);
  EXPECT_EQ(particles.bias[0], std::vector<float>(3, 0.5F));
  particles.bias[1] = {1, 2, 3};
  EXPECT_EQ(select(particles, {2, 0}).bias[1], (std::vector<float>{3, 1}));
  EXPECT_EQ(particles.poses().block(1, 2).bias[1][0], 2);
  EXPECT_EQ(particles.emptyLikeThis().bias.size(), 2u);
}
}  // namespace mrpt_ext::test_particle_set
