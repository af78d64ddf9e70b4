#include "mrpt_ext/report/summary_reader.h"

#include <gtest/gtest.h>

#include "mrpt_ext/evaluation/run_merge.h"
#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/report/summary_json.h"
#include "scratch_folder.h"
#include "synthetic_run.h"

namespace mrpt_ext::test_summary_reader
{
namespace
{
RunScore scoreOfTrial(const RunContext& context, int trial)
{
  return scoreRun(context, testing::syntheticRecord(context, trial), {});
}
}  // namespace

TEST(SummaryReader, ReadsAllOfASummary)
{
  const testing::ScratchFolder folder;
  const RunContext context = testing::syntheticContext();
  const RunScore score = scoreOfTrial(context, 0);
  const std::string text = summaryJson(context, score);
  folder.write("summary.json", text);
  const auto read = readTrialScore(folder.path(), context, 0);
  ASSERT_TRUE(read);
  // The modes at the end are a list of one trial; merged scores have none.
  RunScore without_modes = score;
  without_modes.filter.modes_at_end.reset();
  EXPECT_EQ(summaryJson(context, *read), summaryJson(context, without_modes));
}

TEST(SummaryReader, MergesToTheSameBytesAsTheScoresThemselves)
{
  const testing::ScratchFolder folder;
  const RunContext context = testing::syntheticContext();
  const RunScore first = scoreOfTrial(context, 0), second = scoreOfTrial(context, 1);
  folder.write("summary.json", summaryJson(context, first));
  const auto read = readTrialScore(folder.path(), context, 0);
  ASSERT_TRUE(read);
  EXPECT_EQ(summaryJson(context, mergeScores({*read, second})), summaryJson(context, mergeScores({first, second})));
}

TEST(SummaryReader, RejectsSummariesOfOtherRuns)
{
  const testing::ScratchFolder folder;
  RunContext context = testing::syntheticContext();
  EXPECT_FALSE(readTrialScore(folder.path(), context, 0)) << "no file";
  const std::string text = summaryJson(context, scoreOfTrial(context, 0));
  folder.write("summary.json", text);
  EXPECT_FALSE(readTrialScore(folder.path(), context, 1)) << "another trial";
  RunContext other = context;
  other.seed = context.seed + 1;
  EXPECT_FALSE(readTrialScore(folder.path(), other, 0));
  other = context;
  other.rawlog_sha256 = "another log";
  EXPECT_FALSE(readTrialScore(folder.path(), other, 0));
  other = context;
  other.settings_sha256 = "other settings";
  EXPECT_FALSE(readTrialScore(folder.path(), other, 0));
  other = context;
  other.inputs = {{"map", "map.csv", "an edited map"}};
  EXPECT_FALSE(readTrialScore(folder.path(), other, 0));
  other.inputs = {{"truth", "truth.tum", "another truth"}};
  EXPECT_FALSE(readTrialScore(folder.path(), other, 0));
  RunScore interrupted = scoreOfTrial(context, 0);
  interrupted.verdict_reason = kInterruptedReason + std::string("; one mode");
  folder.write("summary.json", summaryJson(context, interrupted));
  EXPECT_FALSE(readTrialScore(folder.path(), context, 0)) << "interrupted";
  folder.write("summary.json", text.substr(0, text.size() / 2));
  EXPECT_FALSE(readTrialScore(folder.path(), context, 0)) << "damaged";
}
}  // namespace mrpt_ext::test_summary_reader
