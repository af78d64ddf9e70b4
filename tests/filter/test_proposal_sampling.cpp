#include "mrpt_ext/filter/proposal_sampling.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_proposal_sampling
{
namespace
{
const PoseRegion kRegion{{-1, 0}, {3, 2}};
constexpr std::size_t kCount = 40000;

HypothesisSet twoPoses()
{
  return {{.pose = {{0, 1, 0.5}, Vector3d(0.01, 0.01, 0.01).asDiagonal()}, .weight = 0.7},
          {.pose = {{2.9, 0.1, 3}, Vector3d(0.04, 0.04, 0.04).asDiagonal()}, .weight = 0.3}};  // leaks over the corner
}

ParticleSet seedsOf(const HypothesisSet& hypotheses, double uniform_share)
{
  RandomStream random(3);
  const ProposalDistribution mixture(hypotheses, kRegion, uniform_share, 2, {0.03, 0.03, 0.02});
  return sampleSeeds(mixture, kRegion, kCount, random);
}
}  // namespace

TEST(SampleSeeds, LieInTheRegionInTheRequestedNumber)
{
  const ParticleSet seeds = seedsOf(twoPoses(), 0.3);
  ASSERT_EQ(seeds.size(), kCount);
  for (std::size_t i = 0; i < kCount; ++i) EXPECT_TRUE(kRegion.contains(seeds.pose(i)));
}

TEST(SampleSeeds, WeightedSamplesRepresentTheUniformPrior)
{
  ParticleSet seeds = seedsOf(twoPoses(), 0.3);
  normalizeWeights(seeds);
  Vector2d mean = Vector2d::Zero(), square_mean = Vector2d::Zero();
  double ahead = 0;  // share of headings in the half circle about 0
  for (std::size_t i = 0; i < kCount; ++i)
  {
    const double w = std::exp(double{seeds.log_weight[i]});
    mean += w * seeds.pose(i).position();
    square_mean += w * seeds.pose(i).position().cwiseAbs2();
    ahead += std::abs(seeds.phi[i]) < kPi / 2 ? w : 0;
  }
  EXPECT_NEAR(mean.x(), 1, 0.06);
  EXPECT_NEAR(mean.y(), 1, 0.03);
  EXPECT_NEAR(square_mean.x() - square(mean.x()), 16.0 / 12, 0.08);
  EXPECT_NEAR(square_mean.y() - square(mean.y()), 4.0 / 12, 0.03);
  EXPECT_NEAR(ahead, 0.5, 0.03);
}

TEST(SampleSeeds, WeightsArePriorOverProposal)
{
  const ProposalDistribution mixture(twoPoses(), kRegion, 0.3, 2, {0.03, 0.03, 0.02});
  RandomStream random(4);
  const ParticleSet seeds = sampleSeeds(mixture, kRegion, 200, random);
  for (std::size_t i = 0; i < seeds.size(); ++i)
    EXPECT_NEAR(seeds.log_weight[i], std::log(kRegion.density(seeds.pose(i)) / mixture.density(seeds.pose(i))), 1e-4);
}

TEST(SampleSeeds, MostAreWhereTheHypothesesAre)
{
  const ParticleSet seeds = seedsOf(twoPoses(), 0.3);
  std::size_t near = 0;
  for (std::size_t i = 0; i < kCount; ++i)
    near +=
        (seeds.pose(i).position() - Vector2d(0, 1)).norm() < 0.6 && std::abs(wrap(seeds.phi[i] - 0.5)) < 0.6 ? 1 : 0;
  EXPECT_GT(near, kCount * 45 / 100);
}

TEST(SampleSeeds, WithoutHypothesesAllWeightsAreEqual)
{
  const ParticleSet seeds = seedsOf({}, 0.3);
  for (const float log_w : seeds.log_weight) EXPECT_NEAR(log_w, 0, 1e-6);
}

TEST(HypothesesFrom, AreTheModesHeaviestFirst)
{
  ModeSet modes;
  modes.modes = {{{{1, 2, 3}, Matrix3d::Identity() * 0.1}, 0.8}, {{{4, 5, 6}, Matrix3d::Identity()}, 0.19995}};
  const HypothesisSet hypotheses = hypothesesFrom(modes);
  ASSERT_EQ(hypotheses.size(), 2u);
  EXPECT_EQ(hypotheses[0].weight, 0.8);
  EXPECT_NEAR(hypotheses[0].log_score, std::log(0.8), 1e-12);
  EXPECT_EQ(hypotheses[1].pose.mean.x, 4);
  EXPECT_EQ(hypotheses[0].pose.covariance(0, 0), 0.1);
  EXPECT_EQ(hypotheses[0].source, "particles");
  EXPECT_TRUE(hypotheses[0].heading_known);
}

TEST(HypothesesFrom, LeavesTheLightOnesToTheUniformShare)
{
  ModeSet modes;
  modes.modes = {{{}, 0.9999}, {{}, 0.00009}};
  EXPECT_EQ(hypothesesFrom(modes).size(), 1u);
  modes.modes.assign(700, {{}, 1.0 / 700});
  EXPECT_EQ(hypothesesFrom(modes).size(), 500u);
  EXPECT_TRUE(hypothesesFrom({}).empty());
}

TEST(WithWideCopies, HoldsEveryHypothesisTwice)
{
  const HypothesisSet both = withWideCopies(twoPoses(), {0.3, 0.4, 0.5});
  ASSERT_EQ(both.size(), 4u);
  EXPECT_EQ(both[1].pose.covariance, twoPoses()[1].pose.covariance);
  EXPECT_EQ(both[3].pose.mean.x, twoPoses()[1].pose.mean.x);
  EXPECT_NEAR(both[3].pose.covariance(1, 1), 0.04 + 0.16, 1e-12);
}
}  // namespace mrpt_ext::test_proposal_sampling
