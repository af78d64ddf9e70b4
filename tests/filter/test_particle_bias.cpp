#include "mrpt_ext/filter/particles/particle_bias.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_particle_bias
{
namespace
{
constexpr std::size_t kCount = 20000;

ParticleSet manyWith(const BiasModel& biases)
{
  ParticleSet particles({0, 0}, biases);
  for (std::size_t i = 0; i < kCount; ++i) particles.add({0, 0, 0}, 0);
  return particles;
}

struct Moments
{
  double mean = 0, std = 0;
};

Moments momentsOf(const std::vector<float>& values)
{
  double sum = 0, sum2 = 0;
  for (const float v : values)
  {
    sum += v;
    sum2 += square(v);
  }
  const double n = static_cast<double>(values.size()), mean = sum / n;
  return {mean, std::sqrt(sum2 / n - mean * mean)};
}
}  // namespace

TEST(ParticleBias, IsDrawnFromThePrior)
{
  ParticleSet particles = manyWith({{.kind = BiasKind::range_offset, .mean = 0.3, .std = 0.1},
                                    {.kind = BiasKind::distance_scale, .mean = 0.05, .std = 0}});
  RandomStream random(1);
  drawBiases(particles, kCount / 2, random);
  EXPECT_EQ(particles.bias[0][kCount / 2 - 1], 0.3F);  // not asked for
  const std::vector<float> drawn(particles.bias[0].begin() + kCount / 2, particles.bias[0].end());
  EXPECT_NEAR(momentsOf(drawn).mean, 0.3, 0.005);
  EXPECT_NEAR(momentsOf(drawn).std, 0.1, 0.004);
  EXPECT_EQ(particles.bias[1], std::vector<float>(kCount, 0.05F));
}

TEST(ParticleBias, WalksWithTheRootOfTime)
{
  ParticleSet particles = manyWith({{.kind = BiasKind::bearing_offset, .std_per_sqrt_s = 0.02}, {}});
  RandomStream random(2);
  for (int k = 0; k < 9; ++k) walkBiases(particles, 1, random);
  EXPECT_NEAR(momentsOf(particles.bias[0]).std, 0.06, 0.002);
  EXPECT_EQ(particles.bias[1], std::vector<float>(kCount, 0.0F));
}
}  // namespace mrpt_ext::test_particle_bias
