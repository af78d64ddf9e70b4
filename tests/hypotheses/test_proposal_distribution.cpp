#include "mrpt_ext/hypotheses/proposal_distribution.h"

#include <gtest/gtest.h>

#include <limits>

namespace mrpt_ext::test_proposal_distribution
{
namespace
{
const PoseRegion kRegion{{-5, -5}, {5, 5}};
const Vector3d kNoFloor(1e-4, 1e-4, 1e-4);

PoseHypothesis hypothesis(const Pose2& mean, const Vector3d& std, double weight = 1, bool heading_known = true)
{
  return {.pose = {mean, std.cwiseAbs2().asDiagonal()}, .weight = weight, .heading_known = heading_known};
}

/// Integral of the density on a grid of cell centres over the region grown by `margin`.
double integral(const ProposalDistribution& mixture, double margin)
{
  const int n = 120, turns = 72;
  const double half = 5 + margin, cell = 2 * half / n, turn = kTwoPi / turns;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < turns; ++k)
        sum += mixture.density({-half + (i + 0.5) * cell, -half + (j + 0.5) * cell, -kPi + (k + 0.5) * turn});
  return sum * cell * cell * turn;
}

/// Mean of 1 / (density * V) over samples that fall into the region: 1 when samples and density belong together.
double meanInverseDensity(const ProposalDistribution& mixture, int n)
{
  RandomStream random(3);
  double sum = 0;
  for (int i = 0; i < n; ++i)
  {
    const Pose2 pose = mixture.sample(random);
    sum += kRegion.density(pose) / mixture.density(pose);
  }
  return sum / n;
}

/// Share of samples, and integral of the density, in the box |x - cx| < 0.5, |y - cy| < 0.5 and the heading interval.
void expectSameMass(const ProposalDistribution& mixture, const Vector2d& centre, double phi_low, double phi_high)
{
  RandomStream random(5);
  const int samples = 100000, n = 40;
  int hits = 0;
  for (int i = 0; i < samples; ++i)
  {
    const Pose2 pose = mixture.sample(random);
    const bool inside = (pose.position() - centre).cwiseAbs().maxCoeff() < 0.5;
    if (inside && pose.phi >= phi_low && pose.phi < phi_high) ++hits;
  }
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        sum += mixture.density({centre.x() - 0.5 + (i + 0.5) / n, centre.y() - 0.5 + (j + 0.5) / n,
                                phi_low + (phi_high - phi_low) * (k + 0.5) / n});
  const double mass = sum * (phi_high - phi_low) / (n * n * n);
  EXPECT_NEAR(static_cast<double>(hits) / samples, mass, 4 * std::sqrt(mass / samples) + 1e-3);
}
}  // namespace

TEST(ProposalDistribution, DensityIntegratesToOne)
{
  const HypothesisSet two{hypothesis({1, 1, 3.0}, {0.3, 0.4, 0.3}, 0.7), hypothesis({-2, 0, 0}, {0.5, 0.3, 0.4}, 0.3)};
  EXPECT_NEAR(integral({two, kRegion, 0.5, 1.0, kNoFloor}, 1), 1, 1e-3);
}

TEST(ProposalDistribution, AnUnknownHeadingIsUniform)
{
  const ProposalDistribution mixture({hypothesis({1, 1, 0.3}, {0.3, 0.4, 0.001}, 1, false)}, kRegion, 0.2, 1.0,
                                     kNoFloor);
  EXPECT_NEAR(integral(mixture, 1), 1, 1e-3);
  for (const double phi : {-3.0, 0.0, 1.5})
    EXPECT_NEAR(mixture.density({1.1, 1, phi}), mixture.density({1.1, 1, 0.3}), 1e-12);
  expectSameMass(mixture, {1, 1}, 1.0, 2.5);
}

TEST(ProposalDistribution, AVagueHeadingIsNormalisedOnTheCircleToo)
{
  for (const double std_phi : {1.0, 1.5, 3.0, 20.0})
  {
    const ProposalDistribution mixture({hypothesis({0, 0, 2}, {0.4, 0.4, std_phi})}, kRegion, 0.2, 1.0, kNoFloor);
    EXPECT_NEAR(integral(mixture, 0), 1, 2e-3) << std_phi;
    EXPECT_NEAR(meanInverseDensity(mixture, 100000), 1, 0.05) << std_phi;
  }
}

TEST(ProposalDistribution, SamplesFollowTheDensity)
{
  PoseHypothesis tilted = hypothesis({1, 1, 3.0}, {0.3, 0.4, 0.4}, 0.6);
  tilted.pose.covariance(0, 2) = tilted.pose.covariance(2, 0) = 0.06;
  tilted.pose.covariance(0, 1) = tilted.pose.covariance(1, 0) = -0.05;
  const ProposalDistribution mixture({tilted, hypothesis({-2, 0, 0}, {0.5, 0.3, 0.4}, 0.4)}, kRegion, 0.3, 1.5,
                                     kNoFloor);
  expectSameMass(mixture, {1, 1}, 2.5, kPi);
  expectSameMass(mixture, {1.3, 0.8}, -kPi, -2.7);  // beyond the seam
  expectSameMass(mixture, {-2, 0}, -0.5, 0.2);
  expectSameMass(mixture, {4, -4}, -1, 1);  // only the uniform share
}

TEST(ProposalDistribution, ManyPosesTogetherHaveTheDensityOfEach)
{
  PoseHypothesis tilted = hypothesis({1, 1, 3.0}, {0.3, 0.4, 0.4}, 0.6);
  tilted.pose.covariance(0, 2) = tilted.pose.covariance(2, 0) = 0.06;
  tilted.pose.covariance(0, 1) = tilted.pose.covariance(1, 0) = -0.05;
  const HypothesisSet hypotheses{tilted, hypothesis({-2, 0, 0}, {0.01, 0.02, 0.01}, 0.4),
                                 hypothesis({2, 3, -1}, {0.2, 0.2, 1.5}, 0.3),
                                 hypothesis({-3, 3, 1}, {0.5, 0.5, 0.1}, 0.2, false)};
  for (const double uniform_share : {0.0, 0.3})
  {
    const ProposalDistribution mixture(hypotheses, kRegion, uniform_share, 1.5, kNoFloor);
    RandomStream random(8);
    PoseColumns columns({0.5, -0.5});
    for (int i = 0; i < 1000; ++i) columns.add(mixture.sample(random));
    const PoseBatch poses = columns.batch();
    const std::vector<float> densities = mixture.densities(poses);
    ASSERT_EQ(densities.size(), poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i)
      EXPECT_NEAR(densities[i], mixture.density(poses[i]), 1e-3 * mixture.density(poses[i])) << i;
  }
}

TEST(ProposalDistribution, ImportanceWeightsAverageToOne)
{
  const HypothesisSet two{hypothesis({1, 1, 3.0}, {0.3, 0.4, 0.3}, 0.7), hypothesis({4.9, 0, 0}, {0.5, 0.3, 0.4}, 0.3)};
  EXPECT_NEAR(meanInverseDensity({two, kRegion, 0.3, 2.0, kNoFloor}, 200000), 1, 0.02);
}

TEST(ProposalDistribution, WithoutHypothesesItIsTheUniformPrior)
{
  const ProposalDistribution mixture({}, kRegion, 0.3, 2.0, kNoFloor);
  RandomStream random(9);
  for (int i = 0; i < 1000; ++i)
  {
    const Pose2 pose = mixture.sample(random);
    EXPECT_NEAR(mixture.density(pose), kRegion.density(pose), 1e-15);
  }
}

TEST(ProposalDistribution, InvalidCovariancesAreDropped)
{
  PoseHypothesis indefinite = hypothesis({0, 0, 0}, {1, 1, 1}), not_a_number = indefinite, nowhere = indefinite;
  indefinite.pose.covariance(0, 1) = indefinite.pose.covariance(1, 0) = 3;
  not_a_number.pose.covariance(1, 1) = std::numeric_limits<double>::quiet_NaN();
  nowhere.pose.mean.x = std::numeric_limits<double>::infinity();
  const ProposalDistribution none({indefinite, not_a_number, nowhere}, kRegion, 0.3, 1, kNoFloor);
  EXPECT_EQ(none.density({0, 0, 0}), kRegion.density({0, 0, 0}));
  const ProposalDistribution one({indefinite, hypothesis({1, 1, 1}, {0.1, 0.1, 0.1}, 0.001)}, kRegion, 0.3, 1,
                                 kNoFloor);
  EXPECT_EQ(one.density({-3, -3, 0}), 0.3 * kRegion.density({-3, -3, 0}));
  EXPECT_NEAR(meanInverseDensity(one, 100000), 1, 0.02);
}

TEST(ProposalDistribution, AnOverconfidentHypothesisIsInflated)
{
  const ProposalDistribution mixture({hypothesis({0, 0, 0}, {0, 0, 0})}, kRegion, 0, 1, {0.1, 0.2, 0.05});
  RandomStream random(2);
  const int n = 20000;
  Vector3d sum2 = Vector3d::Zero();
  for (int i = 0; i < n; ++i) sum2 += mixture.sample(random).vector().cwiseAbs2();
  const Vector3d std = (sum2 / n).cwiseSqrt();
  EXPECT_NEAR(std.x(), 0.1, 0.003);
  EXPECT_NEAR(std.y(), 0.2, 0.006);
  EXPECT_NEAR(std.z(), 0.05, 0.0015);
}

TEST(ProposalDistribution, TheLeastLikelyHypothesisStillGetsSamples)
{
  const HypothesisSet two{hypothesis({-3, 0, 0}, {0.1, 0.1, 0.1}, 1.0), hypothesis({3, 0, 0}, {0.1, 0.1, 0.1}, 1e-12)};
  const ProposalDistribution mixture(two, kRegion, 0, 1, kNoFloor);
  RandomStream random(4);
  int at_the_second = 0;
  for (int i = 0; i < 5000; ++i) at_the_second += mixture.sample(random).x > 0 ? 1 : 0;
  EXPECT_GT(at_the_second, 50);
}

TEST(ProposalDistribution, TheOverlapCountsTheComponentsThatReachASample)
{
  HypothesisSet apart;
  for (int k = 0; k < 200; ++k) apart.push_back(hypothesis({100.0 * k, 0, 0}, {1, 1, 0.1}));
  EXPECT_DOUBLE_EQ(ProposalDistribution(apart, kRegion, 0.3, 1, kNoFloor).overlap(), 1);
  const HypothesisSet together(200, hypothesis({1, 2, 3}, {1, 1, 0.1}));
  EXPECT_DOUBLE_EQ(ProposalDistribution(together, kRegion, 0.3, 1, kNoFloor).overlap(), 200);
  EXPECT_EQ(ProposalDistribution({}, kRegion, 0.3, 1, kNoFloor).overlap(), 0);
}
}  // namespace mrpt_ext::test_proposal_distribution
