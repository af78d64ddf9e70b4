#include "mrpt_ext/report/comparison_table.h"

#include <gtest/gtest.h>

#include <sstream>

#include "mrpt_ext/evaluation/run_merge.h"
#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/report/number_text.h"
#include "synthetic_run.h"

namespace mrpt_ext::test_comparison_table
{
using namespace testing;

namespace
{
std::string lineWith(const std::string& text, const std::string& part)
{
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (line.find(part) != std::string::npos) return line;
  return {};
}

RunScore syntheticScore(int trial = 0)
{
  const RunContext context = syntheticContext();
  return scoreRun(context, syntheticRecord(context, trial), {});
}
}  // namespace

TEST(NumberText, RoundsWithoutClaimingAllOrNone)
{
  EXPECT_EQ(numberText({}, 2), "-");
  EXPECT_EQ(magnitudeText(0.12345), "0.123");
  EXPECT_EQ(magnitudeText(12.345), "12.35");
  EXPECT_EQ(magnitudeText(1234.5), "1234");
  EXPECT_EQ(percentText(1.0), "100 %");
  EXPECT_EQ(percentText(0.999), ">99 %");
  EXPECT_EQ(percentText(0.001), "<1 %");
  EXPECT_EQ(percentText(0.0), "0 %");
  EXPECT_EQ(countText(10.5), "10.5");
  EXPECT_EQ(countText({}), "-");
}

TEST(ComparisonTable, MarksTheBestAndTheOracle)
{
  const std::string text = comparisonTable(syntheticScore());
  EXPECT_EQ(lineWith(text, "particle_filter  ").substr(0, 17), "* particle_filter");
  EXPECT_EQ(lineWith(text, "oracle_interpretation_tree").substr(0, 2), "o ");  // better, but it uses the truth
  EXPECT_NE(text.find("converged after 8.0 s"), std::string::npos);
  EXPECT_NE(text.find("verdict: ok (one mode"), std::string::npos);
}

TEST(ComparisonTable, TellsThatTheVerdictCameLaterThanTheRightPose)
{
  RunScore score = syntheticScore();
  score.trials.front().converged_at_s = 0.0;
  score.verdict_spells = {{0, 2.2, Verdict::ambiguous, "3 modes"}, {2.4, 90, Verdict::ok, "one mode"}};
  const std::string later = "of the truth); success. Its verdict, which knows no truth, is ok from 2.4 s on.";
  EXPECT_NE(outcomeText(score).find(later), std::string::npos) << outcomeText(score);
  score.trials.front().converged_at_s = 2.0;
  EXPECT_EQ(outcomeText(score).find("Its verdict"), std::string::npos) << "the same, but for the stamps of the scores";
}

TEST(ComparisonTable, TellsThatOkWasWrong)
{
  RunScore score = syntheticScore();
  score.filter.ok_outside = 0;
  EXPECT_EQ(outcomeText(score).find("verdict ok"), std::string::npos);
  score.filter.ok_outside = 17;
  EXPECT_NE(outcomeText(score).find("Estimates outside of these limits with verdict ok: 17."), std::string::npos);
  score.trials.front().converged_at_s.reset();
  score.trials.front().success = false;
  EXPECT_NE(outcomeText(score).find("verdict ok: 17."), std::string::npos) << outcomeText(score);
}

TEST(ComparisonTable, WithoutAnEstimateThereIsNoNumber)
{
  RunScore score = syntheticScore();
  score.trials.front().converged_at_s.reset();
  score.trials.front().success = false;
  for (MethodScore& method : score.methods) method.position_error_whole_run_m = {};
  EXPECT_EQ(outcomeText(score), "particle_filter has no estimate at the times of the truth: no errors.");
}

TEST(ComparisonTable, IsAlignedAndFitsTheConsole)
{
  RunScore score = syntheticScore();
  score.methods[1].name = "oracle_bearing_maximum_likelihood";
  score.verdict_reason = std::string(30, 'a') + ' ' + std::string(60, 'b') + ' ' + std::string(30, 'c');
  std::istringstream stream(comparisonTable(score));
  for (std::string line; std::getline(stream, line);) EXPECT_LE(line.size(), 100u) << line;
  const std::string text = comparisonTable(score);
  const std::size_t right_edge = lineWith(text, "ms per").size();
  EXPECT_EQ(lineWith(text, "* particle_filter").size(), right_edge);
  EXPECT_EQ(lineWith(text, "  odometry").size(), right_edge);
}

TEST(ComparisonTable, MissingNumbersAreDashes)
{
  RunScore score;
  score.trials.resize(1);
  score.judged_method = "particle_filter";
  score.methods.push_back({"particle_filter", true});
  const std::string row = lineWith(comparisonTable(score), "particle_filter  ");
  EXPECT_EQ(std::count(row.begin(), row.end(), '-'), 8);
  EXPECT_EQ(row.find('0'), std::string::npos);
  EXPECT_EQ(comparisonTable(score).find("lowest position RMSE"), std::string::npos);
}

TEST(ComparisonTable, StatesThatTheFilterNeverConverged)
{
  RunContext context = syntheticContext(6);
  const std::string text = comparisonTable(scoreRun(context, syntheticRecord(context), {}));
  EXPECT_NE(text.find("never stayed within 0.50 m / 15 deg"), std::string::npos);
}

TEST(ComparisonTable, TellsHowLateEstimatesCame)
{
  RunScore score = syntheticScore();
  EXPECT_NE(comparisonTable(score).find("5 estimates of the particle filter came late, by up to 3 steps"),
            std::string::npos);
  score.filter.late_estimates = score.filter.most_steps_late = 1;
  EXPECT_NE(comparisonTable(score).find("1 estimate of the particle filter came late, by up to 1 step:"),
            std::string::npos);
  score.filter.late_estimates = 0;
  EXPECT_EQ(comparisonTable(score).find("came late"), std::string::npos);
}

TEST(ComparisonTable, OfSeveralTrialsGivesRateLostRunsAndSpread)
{
  RunScore lost = syntheticScore(1);
  lost.verdict = lost.trials.front().verdict = Verdict::lost;
  lost.trials.front().success = false;
  lost.trials.front().rmse = 1.5;
  std::string text = comparisonTable(mergeScores({syntheticScore(0), lost}));
  std::replace(text.begin(), text.end(), '\n', ' ');
  EXPECT_NE(text.find("2 trials: success rate 0.50, 1 lost"), std::string::npos) << text;
  EXPECT_NE(text.find("to 1.500 m"), std::string::npos) << text;
  EXPECT_NE(text.find("verdict: lost (1 of 2 trials lost"), std::string::npos) << text;
}
}  // namespace mrpt_ext::test_comparison_table
