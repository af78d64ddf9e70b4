#include "mrpt_ext/report/comparison_text.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_comparison_text
{
namespace
{
std::string sentenceFor(double ratio, double low, double high, OptionalNumber cost)
{
  RunScore score;
  score.comparisons = {{"extended_kalman_filter", "particle_filter", ratio, low, high, cost}};
  return comparisonSentences(score).front();
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
}  // namespace

TEST(ComparisonText, ClaimsOnlyWhatTheIntervalAllows)
{
  EXPECT_EQ(sentenceFor(1.01, 0.98, 1.04, 1 / 430.0),
            "extended_kalman_filter is as accurate as particle_filter, at 1/430 of the cost: RMSE 1.01 times (95 %: "
            "0.98 to 1.04)");
  EXPECT_TRUE(contains(sentenceFor(1.01, 0.90, 1.14, 0.01), "not distinguishable in accuracy from"));
  EXPECT_TRUE(contains(sentenceFor(1.3, 1.1, 1.5, 0.01), "is less accurate than"));
  EXPECT_TRUE(contains(sentenceFor(0.8, 0.7, 0.9, 0.01), "is more accurate than"));
  EXPECT_TRUE(contains(sentenceFor(1.02, 1.01, 1.03, 0.01), "is as accurate as")) << "different, but by 3 % at most";
}

TEST(ComparisonText, StatesTheRelativeCostWhereItIsKnown)
{
  EXPECT_TRUE(contains(sentenceFor(1, 1, 1, 2.5), "at 2.5 times the cost"));
  EXPECT_TRUE(contains(sentenceFor(1, 1, 1, 0.25), "at 1/4.0 of the cost"));
  EXPECT_FALSE(contains(sentenceFor(1, 1, 1, {}), "cost"));
}

TEST(ComparisonText, ComparesMethodsThatTrackWithTheBound)
{
  RunScore score;
  EXPECT_TRUE(limitText(score).empty());
  score.limit.why_none = "the truth is sparse";
  EXPECT_TRUE(contains(limitText(score), "no posterior Cramer-Rao bound: the truth is sparse"));

  score.limit = {0.05, 0.5, {}};
  score.judged_method = "particle_filter";
  MethodScore filter, closed_form;
  filter.name = "particle_filter";
  filter.continuous = true;
  filter.position_error_m.rmse = 0.052;
  closed_form.name = "two_landmark_pose";
  closed_form.position_error_m.rmse = 0.3;
  score.methods = {filter, closed_form};
  const std::string text = limitText(score);
  EXPECT_TRUE(contains(text, "0.050 m, heading 0.50 deg; particle_filter 1.04 times the bound")) << text;
  EXPECT_FALSE(contains(text, "two_landmark_pose"));
}
}  // namespace mrpt_ext::test_comparison_text
