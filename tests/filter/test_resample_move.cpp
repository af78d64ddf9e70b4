#include "mrpt_ext/filter/resample_move.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "mrpt_ext/filter/particle_moments.h"

namespace mrpt_ext::test_resample_move
{
namespace
{
constexpr std::size_t kCount = 4000;
const BiasModel kBiases{{.kind = BiasKind::range_offset, .mean = 0.5, .std = 0.2},
                        {.kind = BiasKind::distance_scale, .mean = 0, .std = 0.1},
                        {.kind = BiasKind::range_scale, .mean = 0.03, .std = 0}};

/// Few poses, each of them many times; all in one mode.
ParticleSet copies(std::size_t ancestors, RandomStream& random)
{
  ParticleSet few({0, 0}, kBiases), all({0, 0}, kBiases);
  for (std::size_t i = 0; i < ancestors; ++i)
  {
    few.add({2 + 0.2 * random.gaussian(), -1 + 0.2 * random.gaussian(), 0.1 * random.gaussian()}, 0);
    few.bias[0][i] = static_cast<float>(0.5 + 0.2 * random.gaussian());
    few.bias[1][i] = static_cast<float>(0.1 * random.gaussian());
  }
  for (std::size_t i = 0; i < kCount; ++i) all.addCopy(few, i % ancestors, 0);
  normalizeWeights(all);
  return all;
}

ModeSet oneMode() { return {.modes = {{.weight = 1}}, .mode_of = std::vector<int>(kCount, 0)}; }

std::size_t distinct(const std::vector<float>& values) { return std::set<float>(values.begin(), values.end()).size(); }
}  // namespace

TEST(ResampleMove, CopiesBecomeDrawsOfThePosterior)
{
  // Position about (2, -1), y follows x; the offset of the ranges is known from its prior alone.
  const auto posterior = [](ParticleSet& particles)
  {
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
      const Pose2 p = particles.pose(i);
      const double u = (p.x - 2) / 0.6, v = (p.y + 1 - 0.8 * (p.x - 2)) / 0.2, h = p.phi / 0.3;
      particles.log_weight[i] = static_cast<float>(-0.5 * (u * u + v * v + h * h));
    }
    addBiasLogPrior(particles);
  };
  RandomStream random(1);
  ParticleSet particles = copies(15, random);
  const std::vector<float> distance_scale = particles.bias[1], weight = particles.log_weight;
  for (int k = 0; k < 80; ++k) moveByPosterior(particles, oneMode(), {0, 0}, posterior, random);
  EXPECT_GT(distinct(particles.x), kCount * 9 / 10);
  const auto all = momentsOf(particles, [](std::size_t) { return true; });
  ASSERT_TRUE(all);
  EXPECT_NEAR(all->mean[0], 2, 0.06);
  EXPECT_NEAR(all->mean[1], -1, 0.06);
  EXPECT_NEAR(std::sqrt(all->covariance(0, 0)), 0.6, 0.05);
  EXPECT_NEAR(all->covariance(0, 1), 0.8 * square(0.6), 0.04);
  EXPECT_NEAR(std::sqrt(all->covariance(2, 2)), 0.3, 0.03);
  EXPECT_NEAR(all->mean[3], 0.5, 0.02);
  EXPECT_NEAR(std::sqrt(all->covariance(3, 3)), 0.2, 0.02);
  EXPECT_EQ(particles.bias[1], distance_scale) << "readings of one time do not depend on odometry errors";
  EXPECT_EQ(distinct(particles.bias[2]), 1U) << "what is known stays";
  EXPECT_EQ(particles.log_weight, weight);
}

TEST(ResampleMove, HeadingsThatDiedOutComeBackAboutThePlacesMeasuredFrom)
{
  // The readings were made 3 m behind the robot and constrain that position only.
  const Vector2d pivot(-3, 0), position(5, 1);
  const auto posterior = [&](ParticleSet& particles)
  {
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
      const Pose2 p = particles.pose(i);
      const Vector2d off = p.position() + rotation(p.phi) * pivot - position;
      particles.log_weight[i] = static_cast<float>(-0.5 * off.squaredNorm() / square(0.1));
    }
    addBiasLogPrior(particles);
  };
  ParticleSet particles({0, 0}, kBiases);
  for (std::size_t i = 0; i < kCount; ++i) particles.add({8, 1, 0}, 0);
  RandomStream random(2);
  for (int k = 0; k < 10; ++k) moveByPosterior(particles, oneMode(), pivot, posterior, random);
  std::vector<std::size_t> sector(8);
  for (std::size_t i = 0; i < kCount; ++i)
  {
    const Pose2 p = particles.pose(i);
    EXPECT_LT((p.position() + rotation(p.phi) * pivot - position).norm(), 0.6);
    ++sector[static_cast<std::size_t>((p.phi + kPi) / kTwoPi * 8) % 8];
  }
  for (const std::size_t held : sector) EXPECT_NEAR(static_cast<double>(held), kCount / 8.0, 100);
}

TEST(ResampleMove, NoParticleEntersWhereThePosteriorIsZero)
{
  const auto posterior = [](ParticleSet& particles)
  {
    for (std::size_t i = 0; i < particles.size(); ++i)
      particles.log_weight[i] = particles.x[i] > 0 ? 0.0F : -std::numeric_limits<float>::infinity();
  };
  ParticleSet particles({0, 0}, {});
  RandomStream random(3);
  for (std::size_t i = 0; i < kCount; ++i) particles.add({0.01 + random.uniform(), random.uniform(), 0}, 0);
  moveByPosterior(particles, oneMode(), {0, 0}, posterior, random);
  for (const float x : particles.x) EXPECT_GT(x, 0);
}
}  // namespace mrpt_ext::test_resample_move
