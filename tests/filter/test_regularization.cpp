#include "mrpt_ext/filter/regularization.h"

#include <gtest/gtest.h>

#include <set>

#include "mrpt_ext/filter/particle_moments.h"
#include "mrpt_ext/filter/particles/resampling.h"

namespace mrpt_ext::test_regularization
{
namespace
{
void addCluster(ParticleSet& particles, const Pose2& mean, const Vector3d& std, int count, RandomStream& random)
{
  for (int i = 0; i < count; ++i)
  {
    const double a = random.gaussian(), b = random.gaussian(), c = random.gaussian();
    particles.add({mean.x + std.x() * a + 0.5 * std.x() * b, mean.y + std.y() * b, wrap(mean.phi + std.z() * c)},
                  -std::log(count));
  }
}

/// Mean and covariance of the particles from `first` on; headings near `around`.
GaussianPose momentsOf(const ParticleSet& particles, std::size_t first, std::size_t count, double around)
{
  Vector3d sum = Vector3d::Zero();
  Matrix3d sum2 = Matrix3d::Zero();
  for (std::size_t i = first; i < first + count; ++i)
  {
    Vector3d v = particles.pose(i).vector();
    v.z() = wrap(v.z() - around);
    sum += v;
    sum2 += v * v.transpose();
  }
  const Vector3d mean = sum / static_cast<double>(count);
  const Matrix3d covariance = sum2 / static_cast<double>(count) - mean * mean.transpose();
  return {{mean.x(), mean.y(), wrap(around + mean.z())}, covariance};
}

std::size_t distinctPositions(const ParticleSet& particles)
{
  return std::set<float>(particles.x.begin(), particles.x.end()).size();
}
}  // namespace

TEST(Regularization, KeepsMeanAndCovariance)
{
  RandomStream random(1);
  ParticleSet particles;
  constexpr int kCount = 20000;
  addCluster(particles, {2, -1, kPi - 0.05}, {0.1, 0.2, 0.08}, kCount, random);  // headings wrap at pi
  const GaussianPose before = momentsOf(particles, 0, kCount, kPi);
  const ModeSet modes{{{before, 1}}, std::vector<int>(kCount, 0)};
  const ParticleSet unmoved = particles;
  for (int round = 0; round < 20; ++round) regularizeModes(particles, modes, {.bandwidth = 0.3}, random);
  const GaussianPose after = momentsOf(particles, 0, kCount, kPi);
  EXPECT_NEAR(after.mean.x, before.mean.x, 0.005);
  EXPECT_NEAR(after.mean.y, before.mean.y, 0.01);
  EXPECT_NEAR(std::abs(wrap(after.mean.phi - before.mean.phi)), 0, 0.004);
  EXPECT_LT((after.covariance - before.covariance).norm(), 0.05 * before.covariance.norm());
  EXPECT_EQ(particles.log_weight, unmoved.log_weight);
  EXPECT_NE(particles.x, unmoved.x);
  for (const float phi : particles.phi) EXPECT_LE(std::abs(phi), static_cast<float>(kPi));
}

TEST(Regularization, KeepsTheJointCovarianceOfPoseAndSystematicErrors)
{
  const BiasModel biases{{.kind = BiasKind::range_scale, .std = 0.05}};
  ParticleSet particles(Vector2d(3, 2), biases);
  RandomStream random(5);
  for (int i = 0; i < 4000; ++i)
  {
    const double scale = 0.02 + 0.01 * random.gaussian();
    particles.add({3 + 5 * scale + 0.02 * random.gaussian(), 2 + 0.05 * random.gaussian(), 0.1 * random.gaussian()}, 0);
    particles.bias[0].back() = static_cast<float>(scale);
  }
  normalizeWeights(particles);
  const auto everyone = [](std::size_t) { return true; };
  const KalmanState before = *momentsOf(particles, everyone);
  for (int pass = 0; pass < 20; ++pass) regularizeModes(particles, findModes(particles, {}), {}, random);
  const KalmanState after = *momentsOf(particles, everyone);
  EXPECT_NEAR(after.mean[3], before.mean[3], 0.001);
  EXPECT_NEAR(after.covariance(3, 3) / before.covariance(3, 3), 1, 0.15);
  EXPECT_NEAR(after.covariance(0, 3) / before.covariance(0, 3), 1, 0.15);
  EXPECT_NEAR(after.covariance(0, 0) / before.covariance(0, 0), 1, 0.15);
}

TEST(Regularization, KeepsSeparateModesSeparate)
{
  RandomStream random(2);
  ParticleSet particles;
  addCluster(particles, {0, 0, 0}, {0.1, 0.1, 0.05}, 1000, random);
  addCluster(particles, {2, 0, 0}, {0.1, 0.1, 0.05}, 1000, random);
  addCluster(particles, {0, 0, kPi}, {0.1, 0.1, 0.05}, 1000, random);
  normalizeWeights(particles);
  for (int round = 0; round < 100; ++round) regularizeModes(particles, findModes(particles, {}), {}, random);
  const Pose2 expected[3]{{0, 0, 0}, {2, 0, 0}, {0, 0, kPi}};
  for (std::size_t k = 0; k < 3; ++k)
  {
    const GaussianPose moments = momentsOf(particles, 1000 * k, 1000, expected[k].phi);
    EXPECT_NEAR(moments.mean.x, expected[k].x, 0.04);
    EXPECT_NEAR(std::abs(wrap(moments.mean.phi - expected[k].phi)), 0, 0.02);
    EXPECT_NEAR(std::sqrt(moments.covariance(1, 1)), 0.1, 0.02);
  }
}

TEST(Regularization, AModeInTheTailOfAWiderModeKeepsItsMean)
{
  RandomStream random(3);
  ParticleSet particles;
  addCluster(particles, {0, 0, 0}, {0.3, 0.3, 0.3}, 4000, random);
  addCluster(particles, {0.9, 0, 0}, {0.04, 0.04, 0.04}, 1000, random);
  const ModeSet modes{{{momentsOf(particles, 0, 4000, 0), 0.8}, {momentsOf(particles, 4000, 1000, 0), 0.2}}, {}};
  for (int round = 0; round < 200; ++round) regularizeModes(particles, modes, {}, random);
  EXPECT_NEAR(momentsOf(particles, 4000, 1000, 0).mean.x, 0.9, 0.05);
}

TEST(Regularization, PreventsSampleImpoverishmentAtStandstill)
{
  constexpr std::size_t kCount = 4000;
  RandomStream random(4);
  ParticleSet regularized;
  addCluster(regularized, {1, 1, 1}, {0.1, 0.1, 0.05}, kCount, random);
  ParticleSet copied = regularized;
  const GaussianPose before = momentsOf(regularized, 0, kCount, 1);
  for (int frame = 0; frame < 300; ++frame)
    for (ParticleSet* particles : {&regularized, &copied})
    {
      const ModeSet modes = findModes(*particles, {});
      *particles = resampleByMode(*particles, modes.mode_of, ResamplingMethod::multinomial, kCount, random);
      if (particles == &regularized) regularizeModes(*particles, modes, {}, random);
    }
  EXPECT_LT(distinctPositions(copied), 100u);                    // by resampling alone
  EXPECT_GT(distinctPositions(regularized), kCount * 97 / 100);  // copies may remain in the tails
  const GaussianPose after = momentsOf(regularized, 0, kCount, 1);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_GT(after.covariance(i, i), 0.3 * before.covariance(i, i));
    EXPECT_LT(after.covariance(i, i), 3.0 * before.covariance(i, i));
  }
}

TEST(Regularization, DoesNotMoveParticlesOfWideOrLightModes)
{
  RandomStream random(5);
  ParticleSet wide;
  addCluster(wide, {0, 0, 0}, {0.6, 0.6, 0.05}, 500, random);
  ParticleSet as_it_was = wide;
  const GaussianPose moments = momentsOf(wide, 0, 500, 0);
  regularizeModes(wide, {{{moments, 1}}, {}}, {}, random);
  EXPECT_EQ(wide.x, as_it_was.x);
  ParticleSet light;
  addCluster(light, {0, 0, 0}, {0.1, 0.1, 0.05}, 500, random);
  as_it_was = light;
  regularizeModes(light, {{{momentsOf(light, 0, 500, 0), 0.005}}, {}}, {}, random);
  EXPECT_EQ(light.x, as_it_was.x);
}

TEST(Regularization, AModeWithZeroCovarianceStaysWhereItIs)
{
  RandomStream random(6);
  ParticleSet particles;
  for (int i = 0; i < 10; ++i) particles.add({1, 2, 3}, -std::log(10));
  regularizeModes(particles, findModes(particles, {}), {}, random);
  for (std::size_t i = 0; i < particles.size(); ++i)
    EXPECT_LT((particles.pose(i).vector() - Vector3d(1, 2, 3)).norm(), 1e-6);
  ParticleSet none;
  regularizeModes(none, {}, {}, random);
  EXPECT_TRUE(none.empty());
}
}  // namespace mrpt_ext::test_regularization
