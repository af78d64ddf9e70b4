#include "mrpt_ext/report/comparison_page.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "mrpt_ext/evaluation/run_merge.h"
#include "mrpt_ext/evaluation/run_scoring.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/report/html_tables.h"
#include "mrpt_ext/report/run_writer.h"
#include "scratch_folder.h"
#include "synthetic_run.h"

namespace mrpt_ext::test_comparison_page
{
using namespace testing;
namespace fs = std::filesystem;

namespace
{
class ComparisonPage : public ::testing::Test
{
 protected:
  /// A run of trials first ... last - 1, each in its folder.
  fs::path writeRun(const std::string& name, int first, int last, const std::string& configuration = "[a]\n")
  {
    const fs::path folder = scratch_.path() / name;
    const RunContext context = syntheticContext(60);
    std::vector<RunScore> scores;
    for (int trial = first; trial < last; ++trial)
    {
      const RunRecord record = syntheticRecord(context, trial);
      scores.push_back(scoreRun(context, record, {}));
      fs::create_directories(folder / trialFolder(trial));
      writeTrial(folder / trialFolder(trial), context, record, scores.back());
    }
    writeMerged(folder, context, mergeScores(scores));
    std::ofstream(folder / "config_resolved.ini") << "random_seed = " << first << "\n" << configuration;
    return folder;
  }

  ScratchFolder scratch_;
};
}  // namespace

TEST_F(ComparisonPage, PartsOfOneStudyAreOneRun)
{
  const auto runs = readFinishedRuns({writeRun("a", 0, 2), writeRun("b", 2, 5)});
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].name, "room");
  EXPECT_EQ(runs[0].trials.size(), 5u);
  EXPECT_EQ(runs[0].folders.size(), 2u);
  EXPECT_EQ(runs[0].methods.size(), 7u);
  EXPECT_EQ(runs[0].trials[4].score.trial, 4);
  EXPECT_GT(*runs[0].trials[4].position_rmse_m.at("particle_filter"), 0);
}

TEST_F(ComparisonPage, TheSameTrialCountsOnce)
{
  const auto runs = readFinishedRuns({writeRun("a", 0, 3), writeRun("b", 2, 4)});
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].trials.size(), 4u);
  EXPECT_EQ(runs[0].repeated, 1u);
  EXPECT_NE(comparisonPage(runs).find("1 trials given twice"), std::string::npos);
}

TEST_F(ComparisonPage, OtherSettingsAreAnotherRun)
{
  const auto runs = readFinishedRuns({writeRun("a", 0, 2), writeRun("b", 0, 2, "[b]\n")});
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].name, "room");
  EXPECT_EQ(runs[1].name, "room 2");
}

TEST_F(ComparisonPage, APageShowsEveryRunAndMethod)
{
  const auto runs = readFinishedRuns({writeRun("a", 0, 6), writeRun("b", 0, 2, "[b]\n")});
  const std::string html = comparisonPage(runs);
  for (const char* part : {"room 2", "particle_", "interpretation_", "6 of 6", "61 % – 100 %", "2 runs, 8 trials"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("http:"), std::string::npos);
}

TEST_F(ComparisonPage, AFolderWithoutASummaryIsADataError)
{
  fs::create_directories(scratch_.path() / "empty");
  EXPECT_THROW((void)readFinishedRuns({scratch_.path() / "empty"}), InputError);
  std::ofstream(scratch_.path() / "empty" / "summary.json") << R"({"schema": 1})";
  EXPECT_THROW((void)readFinishedRuns({scratch_.path() / "empty"}), InputError);
  std::ofstream(scratch_.path() / "empty" / "summary.json") << "{";
  EXPECT_THROW((void)readFinishedRuns({scratch_.path() / "empty"}), InputError);
}

// Wilson's interval as tabulated by Newcombe, Statistics in Medicine 17, 1998, table I.
TEST(SuccessInterval, OfKnownCounts)
{
  EXPECT_NEAR(successInterval(81, 263).first, 0.2553, 1e-4);
  EXPECT_NEAR(successInterval(81, 263).second, 0.3662, 1e-4);
  EXPECT_NEAR(successInterval(0, 20).first, 0.0, 1e-12);
  EXPECT_NEAR(successInterval(0, 20).second, 0.1611, 1e-4);
  EXPECT_EQ(successInterval(0, 0), std::make_pair(0.0, 1.0));
}
}  // namespace mrpt_ext::test_comparison_page
