#include "mrpt_ext/report/study_table.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_study_table
{
namespace
{
FinishedTrial trialOf(double rmse, std::optional<bool> success, Verdict verdict)
{
  FinishedTrial trial;
  trial.score.success = success;
  trial.score.verdict = verdict;
  if (success) trial.score.converged_at_s = 10 * rmse;
  trial.position_rmse_m = {{"particle_filter", rmse}, {"running_fix", std::nullopt}};
  trial.position_median_m = {{"particle_filter", rmse / 2}};
  trial.position_p95_m = {{"particle_filter", 2 * rmse}};
  trial.heading_rmse_deg = {{"particle_filter", std::nullopt}};
  trial.ok_share = {{"particle_filter", 0.9}};
  trial.coverage_95 = {{"particle_filter", 0.95}};
  return trial;
}

std::vector<FinishedRun> twoRuns()
{
  FinishedRun first, second;
  first.name = "room";
  first.rawlog_path = "/logs/first.rawlog";
  first.methods = {"particle_filter", "running_fix"};
  first.settings = {{"A.particles", "100"}, {"A.seed", "1"}};
  first.trials = {trialOf(0.1, true, Verdict::ok), trialOf(0.3, true, Verdict::ok), trialOf(0.2, false, Verdict::lost)};
  second = first;
  second.name = "room 2";
  second.settings["A.particles"] = "a, b";
  second.trials.pop_back();
  return {first, second};
}
}  // namespace

TEST(StudyTable, MarkdownHoldsMediansOverTheTrials)
{
  const std::string table = studyMarkdown(twoRuns());
  EXPECT_NE(
      table.find("| room | first | particle_filter | 3 | 2 | 1 | 2.0 | 0.200 | 0.100 | 0.400 | - | 0.900 | 0.950 |\n"),
      std::string::npos)
      << table;
  EXPECT_EQ(table.find("running_fix"), std::string::npos) << "it has no error";
}

TEST(StudyTable, CsvNamesTheSettingsThatDiffer)
{
  EXPECT_EQ(studyCsv(twoRuns()),
            "A.particles,run,log,method,trials,successes,lost,converged_s,rmse_m,median_m,p95_m,heading_rmse_deg,ok_"
            "share,coverage_95\n"
            "100,room,first,particle_filter,3,2,1,2.0,0.200,0.100,0.400,,0.900,0.950\n"
            "\"a, b\",room 2,first,particle_filter,2,2,0,2.0,0.200,0.100,0.400,,0.900,0.950\n");
}

TEST(StudyTable, AStudyWithoutASuccessHasItsRow)
{
  std::vector<FinishedRun> runs = twoRuns();
  for (FinishedTrial& trial : runs[1].trials)
  {
    trial.score.success = false;
    trial.score.converged_at_s.reset();
    trial.position_rmse_m = trial.position_median_m = trial.position_p95_m = {};
  }
  EXPECT_NE(studyCsv(runs).find("\"a, b\",room 2,first,particle_filter,2,0,0,,,,,,0.900,0.950\n"), std::string::npos);
}
}  // namespace mrpt_ext::test_study_table
