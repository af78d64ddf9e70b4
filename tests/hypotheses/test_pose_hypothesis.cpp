#include "mrpt_ext/hypotheses/pose_hypothesis.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <numeric>

namespace mrpt_ext::test_pose_hypothesis
{
namespace
{
PoseHypothesis at(const Pose2& mean, double log_score, bool heading_known = true)
{
  return {.pose = {mean, Matrix3d::Identity() * 0.01}, .log_score = log_score, .heading_known = heading_known};
}

double weightSum(const HypothesisSet& hypotheses)
{
  return std::accumulate(hypotheses.begin(), hypotheses.end(), 0.0,
                         [](double sum, const PoseHypothesis& h) { return sum + h.weight; });
}
}  // namespace

TEST(RankByScore, WeightsAreTheNormalisedLikelihoods)
{
  HypothesisSet hypotheses{at({1, 0, 0}, std::log(1.0)), at({2, 0, 0}, std::log(3.0)), at({3, 0, 0}, std::log(4.0))};
  rankByScore(hypotheses);
  EXPECT_EQ(hypotheses[0].pose.mean.x, 3);
  EXPECT_NEAR(hypotheses[0].weight, 0.5, 1e-12);
  EXPECT_NEAR(hypotheses[1].weight, 0.375, 1e-12);
  EXPECT_NEAR(hypotheses[2].weight, 0.125, 1e-12);
}

TEST(RankByScore, EqualScoresKeepTheirOrder)
{
  HypothesisSet hypotheses{at({1, 0, 0}, -5), at({2, 0, 0}, -5), at({3, 0, 0}, -5)};
  rankByScore(hypotheses);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(hypotheses[static_cast<std::size_t>(i)].pose.mean.x, i + 1);
}

TEST(RankByScore, NothingToRank)
{
  HypothesisSet none;
  rankByScore(none);
  EXPECT_TRUE(none.empty());
}

TEST(RankByScore, AnImpossibleHypothesisGetsNoWeight)
{
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  HypothesisSet hypotheses{at({1, 0, 0}, kNever), at({2, 0, 0}, -3)};
  rankByScore(hypotheses);
  EXPECT_EQ(hypotheses[0].weight, 1);
  EXPECT_EQ(hypotheses[1].weight, 0);
}

RC_GTEST_PROP(RankByScore, WeightsSumToOneHoweverSmallTheLikelihoods, (const std::vector<int>& scores))
{
  RC_PRE(!scores.empty());
  HypothesisSet hypotheses;
  for (const int score : scores) hypotheses.push_back(at({}, -1000.0 * std::abs(score % 1000)));
  rankByScore(hypotheses);
  RC_ASSERT(std::abs(weightSum(hypotheses) - 1) < 1e-12);
  RC_ASSERT(std::is_sorted(hypotheses.begin(), hypotheses.end(),
                           [](const auto& a, const auto& b) { return a.log_score > b.log_score; }));
}

TEST(MergeDuplicates, KeepsTheBetterOfTwoNeighbours)
{
  HypothesisSet hypotheses{at({0, 0, 0}, -2), at({0.1, 0, 0.05}, -1), at({3, 0, 0}, -3)};
  mergeDuplicates(hypotheses, 0.3, 0.2);
  ASSERT_EQ(hypotheses.size(), 2u);
  EXPECT_EQ(hypotheses[0].log_score, -1);
  EXPECT_EQ(hypotheses[1].log_score, -3);
}

TEST(MergeDuplicates, HeadingsAreComparedOnTheCircle)
{
  HypothesisSet hypotheses{at({0, 0, kPi - 0.05}, -1), at({0, 0, -kPi + 0.05}, -2), at({0, 0, 1}, -3)};
  mergeDuplicates(hypotheses, 0.3, 0.2);
  ASSERT_EQ(hypotheses.size(), 2u);
  EXPECT_EQ(hypotheses[1].pose.mean.phi, 1);
}

TEST(MergeDuplicates, AnUnknownHeadingOnlyMergesWithItsLike)
{
  HypothesisSet hypotheses{at({0, 0, 0}, -1, false), at({0, 0, 2}, -2, false), at({0, 0, 0}, -3, true)};
  mergeDuplicates(hypotheses, 0.3, 0.2);
  ASSERT_EQ(hypotheses.size(), 2u);
  EXPECT_FALSE(hypotheses[0].heading_known);
  EXPECT_TRUE(hypotheses[1].heading_known);
}
}  // namespace mrpt_ext::test_pose_hypothesis
