#include "mrpt_ext/filter/hypothesis_injector.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_hypothesis_injector
{
namespace
{
const Pose2 kHere{1, 1, 0}, kThere{5, 4, 2};

PoseHypothesis hypothesis(const Pose2& pose, double weight)
{
  PoseHypothesis h;
  h.pose = {pose, Vector3d(0.01, 0.04, 0.0025).asDiagonal()};
  h.weight = weight;
  return h;
}

ParticleSet oneHundredAt(const Pose2& pose)
{
  ParticleSet particles(Vector2d(0, 0));
  for (int i = 0; i < 100; ++i) particles.add(pose, std::log(0.01));
  return particles;
}

HypothesisInjector injectorOf(std::size_t particles, const RecoveryOptions& options = {})
{
  return {options, {{0, 0}, {10, 10}}, particles};
}

double weightOf(const ParticleSet& particles, std::size_t from)
{
  double sum = 0;
  for (std::size_t i = from; i < particles.size(); ++i) sum += std::exp(double{particles.log_weight[i]});
  return sum;
}
}  // namespace

TEST(HypothesisInjector, InjectedParticlesHaveThePriorOfTheRelocalization)
{
  RandomStream random(2);
  ParticleSet particles = oneHundredAt(kHere);
  const HypothesisInjector injector = injectorOf(20000, {.injected_particle_share = 1, .slip_share = 0});
  injector.inject(particles, {hypothesis(kThere, 1)}, {}, 0.3, random);
  EXPECT_EQ(injector.count(), 20000U);
  EXPECT_NEAR(weightOf(particles, 0) - weightOf(particles, 100), 0.7, 1e-4);
  EXPECT_NEAR(weightOf(particles, 100), 0.3, 0.02);
  // Many are near the hypothesis, yet it gets no more weight than any other part of the region.
  std::size_t near = 0;
  double weight_near = 0;
  for (std::size_t i = 100; i < particles.size(); ++i)
  {
    if ((particles.pose(i).position() - kThere.position()).norm() > 1) continue;
    ++near;
    weight_near += std::exp(double{particles.log_weight[i]});
  }
  EXPECT_GT(near, particles.size() / 2);
  EXPECT_NEAR(weight_near, 0.3 * kPi / 100, 0.003);
}

TEST(HypothesisInjector, AWheelSlipIsNearTheMode)
{
  RandomStream random(3);
  const HypothesisInjector injector = injectorOf(4000, {.injected_particle_share = 1, .slip_share = 0.5});
  const HypothesisSet slipped = injector.withSlip({hypothesis(kThere, 1)});
  ASSERT_EQ(slipped.size(), 1U);
  EXPECT_NEAR(slipped[0].pose.covariance(0, 0), 0.01 + 0.09, 1e-12);
  ParticleSet particles = oneHundredAt(kThere);
  injector.inject(particles, {}, slipped, 0.2, random);
  double near = 0;
  for (std::size_t i = 100; i < particles.size(); ++i)
    if ((particles.pose(i).position() - kThere.position()).norm() < 1)
      near += std::exp(double{particles.log_weight[i]});
  EXPECT_GT(near, 0.08);  // about half of 0.2
  EXPECT_LT(near, 0.12);
  EXPECT_TRUE(injectorOf(10, {.slip_share = 0}).withSlip({hypothesis(kThere, 1)}).empty());
}

TEST(HypothesisInjector, ATrajectoryThatAgreesWithTheBestModeInjectsNothing)
{
  EXPECT_EQ(weightElsewhere({}, kHere), 0);
  EXPECT_EQ(weightElsewhere({hypothesis({1.2, 0.9, 0.1}, 1)}, kHere), 0);
  EXPECT_EQ(injectedShare(0, 0), 0);
}

TEST(HypothesisInjector, HypothesesElsewhereCountByTheirOddsUpToTen)
{
  EXPECT_NEAR(weightElsewhere({hypothesis(kThere, 0.5), hypothesis(kHere, 0.3)}, kHere), 0.5, 1e-12);
  EXPECT_NEAR(injectedShare(0.5, 0), 0.5, 1e-12);
  EXPECT_NEAR(injectedShare(0.999, 0), 10.0 / 11, 1e-12);
  EXPECT_NEAR(injectedShare(1, -3), 10.0 / 11, 1e-12);
}

TEST(HypothesisInjector, TheLogOddsOfTheBestModeCountAgainstOtherHypotheses)
{
  EXPECT_LT(injectedShare(1, 9), kMinInjectedWeight);
  EXPECT_NEAR(injectedShare(1, std::log(10)), 0.5, 1e-12);
}

TEST(HypothesisInjector, TrajectoryHypothesesGetTheirShareAndTheirCovariance)
{
  RandomStream random(1);
  ParticleSet particles = oneHundredAt(kHere);
  injectorOf(500).injectTrajectory(
      particles, {hypothesis(kThere, 0.6), hypothesis({9, 9, 1}, 0.2), hypothesis({2, 7, 1}, 1e-4)}, 0.8, random);
  ASSERT_EQ(particles.size(), 1100U);
  double kept = 0, there = 0, total = 0;
  Vector2d mean(0, 0);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const double w = std::exp(double{particles.log_weight[i]});
    total += w;
    if (i < 100) kept += w;
    if ((particles.pose(i).position() - kThere.position()).norm() > 2) continue;
    there += w;
    mean += w * particles.pose(i).position();
  }
  EXPECT_NEAR(kept, 0.2, 1e-5);
  EXPECT_NEAR(there, 0.6, 1e-3);
  EXPECT_NEAR(total, 1, 1e-3);
  EXPECT_LT((mean / there - kThere.position()).norm(), 1e-4);  // the drawn moments are exact
}

TEST(HypothesisInjector, WithoutTrajectoryHypothesesNothingChanges)
{
  RandomStream random(1);
  ParticleSet particles = oneHundredAt(kHere);
  injectorOf(500).injectTrajectory(particles, {}, 0.5, random);
  EXPECT_EQ(particles.size(), 100U);
  EXPECT_FLOAT_EQ(particles.log_weight[0], std::log(0.01F));
}
}  // namespace mrpt_ext::test_hypothesis_injector
