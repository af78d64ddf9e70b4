#include "mrpt_ext/report/verdict_text.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_verdict_text
{
namespace
{
RunScore scoreWith(std::vector<VerdictSpell> spells)
{
  RunScore score;
  score.verdict = Verdict::ok;
  score.verdict_shares = {0.9, 0.1, 0.0};
  score.verdict_spells = std::move(spells);
  return score;
}
}  // namespace

TEST(VerdictText, TellsSharesAndTheLongestSpellsInOrderOfTime)
{
  const std::string text = verdictHistoryText(scoreWith({{0, 2, Verdict::ambiguous, "3 modes"},
                                                         {2.1, 9, Verdict::ok, "one mode"},
                                                         {9.1, 9.2, Verdict::ambiguous, "short"},
                                                         {9.3, 20, Verdict::ok, "one mode"},
                                                         {20.1, 24, Verdict::lost, "few inliers"},
                                                         {25, 26, Verdict::ambiguous, "2 modes"}}));
  EXPECT_EQ(text,
            "         ok 90 %, ambiguous 10 %, lost 0 % of the frames\n"
            "         0.0 to 2.0 s ambiguous: 3 modes\n"
            "         20.1 to 24.0 s lost: few inliers\n"
            "         25.0 to 26.0 s ambiguous: 2 modes\n"
            "         and 1 shorter spell without `ok`, see report.html\n"
            "what to do: section \"What to do\" of apps/landmark-localization/README.md\n");
}

TEST(VerdictText, TheStartAloneNeedsNoAdvice)
{
  EXPECT_FALSE(needsAdvice(scoreWith({{0, 2, Verdict::ambiguous, ""}, {2.1, 9, Verdict::ok, ""}})));
  EXPECT_TRUE(needsAdvice(scoreWith({{0, 2, Verdict::ok, ""}, {2.1, 9, Verdict::ambiguous, ""}})));
}

TEST(VerdictText, WithoutAHistoryThereIsNothingToTell)
{
  RunScore score;
  score.verdict = Verdict::ok;
  EXPECT_EQ(verdictHistoryText(score), "");
}
}  // namespace mrpt_ext::test_verdict_text
