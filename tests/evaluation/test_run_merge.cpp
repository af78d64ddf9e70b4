#include "mrpt_ext/evaluation/run_merge.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_run_merge
{
namespace
{
RunScore trialWith(int trial, OptionalNumber rmse, bool success, Verdict verdict)
{
  RunScore score;
  score.judged_method = "particle_filter";
  score.verdict = verdict;
  score.verdict_reason = "reason " + std::to_string(trial);
  score.trials.push_back({trial, 100u + static_cast<unsigned>(trial), success, verdict, rmse, {}});
  score.success_rate = success ? 1.0 : 0.0;
  MethodScore method;
  method.name = "particle_filter";
  method.estimates = 10;
  method.position_error_m.rmse = rmse;
  score.methods.push_back(method);
  score.verdict_shares = {verdict == Verdict::ok ? 0.9 : 0.3, 0.1, {}};
  score.verdict_spells = {{0, 1, verdict, "reason"}};
  score.landmarks["1"].inlier_rate = 0.5;
  score.filter.modes_at_end.emplace();
  return score;
}
}  // namespace

TEST(MergeScores, NumbersAreMediansOverTheTrialsThatHaveThem)
{
  const RunScore merged = mergeScores({trialWith(0, 0.1, true, Verdict::ok), trialWith(1, {}, false, Verdict::lost),
                                       trialWith(2, 0.3, true, Verdict::ok), trialWith(3, 0.2, true, Verdict::ok)});
  EXPECT_DOUBLE_EQ(*merged.methods.front().position_error_m.rmse, 0.2);
  EXPECT_EQ(merged.methods.front().estimates, 10.0);
  EXPECT_FALSE(merged.methods.front().heading_error_deg.rmse);
  EXPECT_EQ(merged.success_rate, 0.75);
  EXPECT_EQ(merged.trials.size(), 4u);
  EXPECT_EQ(merged.trials[3].seed, 103u);
  EXPECT_EQ(merged.landmarks.at("1").inlier_rate, 0.5);
  EXPECT_FALSE(merged.filter.modes_at_end);
}

TEST(MergeScores, SharesOfVerdictsAreMeans)
{
  const RunScore merged = mergeScores({trialWith(0, 0.1, true, Verdict::ok), trialWith(1, {}, false, Verdict::lost)});
  EXPECT_NEAR(*merged.verdict_shares.ok, 0.6, 1e-12);
  EXPECT_FALSE(merged.verdict_shares.lost);
  EXPECT_FALSE(merged.verdict_spells);
}

TEST(MergeScores, TheWorstVerdictWins)
{
  const RunScore merged = mergeScores({trialWith(0, 0.1, true, Verdict::ok), trialWith(1, {}, false, Verdict::lost),
                                       trialWith(2, 0.3, true, Verdict::ambiguous)});
  EXPECT_EQ(merged.verdict, Verdict::lost);
  EXPECT_EQ(merged.verdict_reason, "1 of 3 trials lost; trial 1: reason 1");
}

TEST(MergeScores, AMethodOfSomeTrialsOnlyIsKept)
{
  RunScore second = trialWith(1, 0.3, true, Verdict::ok);
  second.methods.push_back({"running_fix", false, false, 7.0});
  const RunScore merged = mergeScores({trialWith(0, 0.1, true, Verdict::ok), second});
  ASSERT_EQ(merged.methods.size(), 2u);
  EXPECT_EQ(merged.methods[1].estimates, 7.0);
}

TEST(MergeScores, OneTrialStaysAsItIs)
{
  const RunScore merged = mergeScores({trialWith(4, 0.1, true, Verdict::ok)});
  EXPECT_EQ(merged.verdict_reason, "reason 4");
  EXPECT_TRUE(merged.filter.modes_at_end);
}
}  // namespace mrpt_ext::test_run_merge
