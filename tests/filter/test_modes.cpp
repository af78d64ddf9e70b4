#include "mrpt_ext/filter/modes/modes.h"

#include <gtest/gtest.h>

#include <numeric>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_modes
{
namespace
{
/// Adds `count` normally distributed particles that weigh `weight` together.
void addCluster(ParticleSet& particles, RandomStream& random, const Pose2& mean, const Vector3d& std, double weight,
                int count = 2000)
{
  for (int i = 0; i < count; ++i)
  {
    const double a = random.gaussian(), b = random.gaussian(), c = random.gaussian();
    particles.add({mean.x + std.x() * a, mean.y + std.y() * b, wrap(mean.phi + std.z() * c)}, std::log(weight / count));
  }
}

double weightSum(const ModeSet& set)
{
  return std::accumulate(set.modes.begin(), set.modes.end(), 0.0,
                         [](double sum, const Mode& mode) { return sum + mode.weight; });
}
}  // namespace

TEST(Modes, TwoClustersAreTwoModes)
{
  ParticleSet particles;
  RandomStream random(1);
  addCluster(particles, random, {1, 1, 0.5}, {0.1, 0.2, 0.1}, 0.3);
  addCluster(particles, random, {6, 4, -2}, {0.2, 0.1, 0.05}, 0.7);
  const ModeSet set = findModes(particles, {});
  ASSERT_EQ(set.modes.size(), 2u);
  EXPECT_NEAR(set.modes[0].weight, 0.7, 1e-6);
  EXPECT_NEAR(set.modes[1].weight, 0.3, 1e-6);
  const Mode& heavy = set.modes[0];
  EXPECT_NEAR(heavy.pose.mean.x, 6, 0.02);
  EXPECT_NEAR(heavy.pose.mean.y, 4, 0.01);
  EXPECT_NEAR(heavy.pose.mean.phi, -2, 0.005);
  EXPECT_NEAR(std::sqrt(heavy.pose.covariance(0, 0)), 0.2, 0.015);
  EXPECT_NEAR(std::sqrt(heavy.pose.covariance(1, 1)), 0.1, 0.008);
  EXPECT_NEAR(std::sqrt(heavy.pose.covariance(2, 2)), 0.05, 0.004);
  EXPECT_NEAR(heavy.pose.covariance(0, 1), 0, 0.002);
  for (std::size_t i = 0; i < particles.size(); ++i) EXPECT_EQ(set.mode_of[i], particles.x[i] < 3.5 ? 1 : 0);
}

TEST(Modes, OppositeHeadingsAtTheSamePositionAreTwoModes)
{
  ParticleSet particles;
  RandomStream random(2);
  addCluster(particles, random, {1, 1, 0}, {0.1, 0.1, 0.1}, 0.5);
  addCluster(particles, random, {1, 1, kPi}, {0.1, 0.1, 0.1}, 0.5);
  const ModeSet set = findModes(particles, {});
  ASSERT_EQ(set.modes.size(), 2u);
  for (const Mode& mode : set.modes) EXPECT_NEAR(std::abs(std::cos(mode.pose.mean.phi)), 1, 1e-3);
}

TEST(Modes, AClusterWithHeadingsAroundPiIsOneMode)
{
  ParticleSet particles;
  RandomStream random(3);
  addCluster(particles, random, {1, 1, kPi}, {0.1, 0.1, 0.15}, 1);
  const ModeSet set = findModes(particles, {});
  ASSERT_EQ(set.modes.size(), 1u);
  EXPECT_NEAR(std::abs(wrap(set.modes[0].pose.mean.phi - kPi)), 0, 0.02);
  EXPECT_NEAR(std::sqrt(set.modes[0].pose.covariance(2, 2)), 0.15, 0.01);
}

TEST(Modes, TheBestModeIsNeverTheMeanOfTwoClusters)
{
  for (std::uint64_t seed = 0; seed < 50; ++seed)
  {
    ParticleSet particles;
    RandomStream random(seed);
    addCluster(particles, random, {-1, 0, 0}, {0.15, 0.15, 0.1}, 0.5, 300);
    addCluster(particles, random, {1, 0, 0}, {0.15, 0.15, 0.1}, 0.5, 300);
    EXPECT_GT(std::abs(findModes(particles, {}).modes.front().pose.mean.x), 0.9) << "seed " << seed;
  }
}

TEST(Modes, ABroadGaussianIsOneMode)
{
  for (const double std : {0.3, 0.6, 1.0})
  {
    ParticleSet particles;
    RandomStream random(4);
    addCluster(particles, random, {2, 3, 1}, {std, std, 0.3}, 1, 20000);
    const ModeSet set = findModes(particles, {});
    EXPECT_GT(set.modes.front().weight, 0.99) << std;
    EXPECT_NEAR(set.modes.front().pose.mean.x, 2, 0.05);
    EXPECT_NEAR(std::sqrt(set.modes.front().pose.covariance(0, 0)), std, 0.05 * std);
    for (std::size_t i = 1; i < set.modes.size(); ++i)
      EXPECT_LT(set.modes[i].weight, 0.005);  // single particles in the tails
  }
}

TEST(Modes, AUniformDistributionIsOneWideModeNotManyNarrowOnes)
{
  ParticleSet particles;
  RandomStream random(5);
  for (int i = 0; i < 20000; ++i)
    particles.add({random.uniform(0, 6), random.uniform(0, 6), random.uniform(-kPi, kPi)}, -std::log(20000));
  const ModeSet set = findModes(particles, {});
  EXPECT_GT(set.modes.front().weight, 0.95);
  EXPECT_NEAR(std::sqrt(set.modes.front().pose.covariance(0, 0)), 6 / std::sqrt(12.0), 0.1);
  EXPECT_NEAR(weightSum(set), 1, 1e-5);
}

TEST(Modes, AFewParticlesBetweenTwoPeaksDoNotMergeThem)
{
  ParticleSet particles;
  RandomStream random(6);
  addCluster(particles, random, {0, 0, 0}, {0.1, 0.1, 0.05}, 0.495);
  addCluster(particles, random, {3, 0, 0}, {0.1, 0.1, 0.05}, 0.495);
  for (int i = 0; i < 300; ++i) particles.add({0.01 * i, 0, 0}, std::log(0.01 / 300));
  const ModeSet set = findModes(particles, {});
  ASSERT_EQ(set.modes.size(), 2u);
  for (const Mode& mode : set.modes) EXPECT_NEAR(mode.weight, 0.5, 0.01);
}

TEST(Modes, OneParticleIsOneModeWithZeroCovariance)
{
  ParticleSet particles;
  particles.add({1, 2, 3}, 0);
  const ModeSet set = findModes(particles, {});
  ASSERT_EQ(set.modes.size(), 1u);
  EXPECT_EQ(set.modes[0].weight, 1);
  EXPECT_NEAR(set.modes[0].pose.mean.phi, 3, 1e-6);
  EXPECT_TRUE(set.modes[0].pose.covariance.isZero(1e-20));
  EXPECT_EQ(set.mode_of, std::vector<int>{0});
}

TEST(Modes, NoParticlesGiveNoModes)
{
  const ModeSet set = findModes({}, {});
  EXPECT_TRUE(set.modes.empty());
  EXPECT_TRUE(set.mode_of.empty());
}

TEST(Modes, ModesAreSortedByWeightAndDeterministic)
{
  ParticleSet particles;
  RandomStream random(8);
  for (int k = 0; k < 10; ++k)
    addCluster(particles, random, {3.0 * k, random.uniform(0, 5), random.uniform(-3, 3)}, {0.2, 0.2, 0.2}, 0.1, 200);
  const ModeSet a = findModes(particles, {}), b = findModes(particles, {});
  ASSERT_EQ(a.modes.size(), b.modes.size());
  EXPECT_EQ(a.mode_of, b.mode_of);
  for (std::size_t i = 0; i < a.modes.size(); ++i)
  {
    EXPECT_EQ(a.modes[i].weight, b.modes[i].weight);
    EXPECT_EQ(a.modes[i].pose.mean.vector(), b.modes[i].pose.mean.vector());
    EXPECT_LE(a.modes[i].weight, a.modes[i > 0 ? i - 1 : 0].weight);
  }
  EXPECT_NEAR(weightSum(a), 1, 1e-5);
}
}  // namespace mrpt_ext::test_modes
