#include <gtest/gtest.h>

#include <algorithm>

#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/tum.h"
#include "scratch_folder.h"
#include "whole_runs.h"

// The verdict of a run is what its exit code says, and a map that does not fit is never answered with a sure pose.
namespace mrpt_ext::test_run_judgement
{
namespace
{
namespace fs = std::filesystem;
using testing::Arguments;

/// The map with the positions of its landmarks dealt out anew, all to another landmark.
fs::path shuffledMap(const fs::path& map, const fs::path& target)
{
  const LandmarkTable right = readLandmarkCsv(map);
  std::vector<Landmark> wrong = right.all();
  for (std::size_t j = 0; j < wrong.size(); ++j)
    wrong[j].position = right[(j + right.size() / 2) % right.size()].position;
  writeLandmarkCsv(target, LandmarkTable(wrong));
  return target;
}
}  // namespace

TEST(RunJudgement, FailAbove)
{
  const testing::ScratchFolder folder;
  const Arguments run{
      testing::shipped("landmark-localization", "half-field"), "--duration", "20", "-q", "-o", folder.path() / "run"};
  const auto strict = testing::localize(testing::joined(run, {"--fail-above", "0.0001"}));
  EXPECT_EQ(strict.exit_code, 3);
  EXPECT_EQ(std::count(strict.err.begin(), strict.err.end(), '\n'), 1) << strict.err;
  EXPECT_NE(strict.err.find("--fail-above"), std::string::npos);
  EXPECT_EQ(testing::summaryOf(folder.path() / "run").at("verdict"), "ok") << "the results are written all the same";
  const auto easy = testing::localize(testing::joined(run, {"--fail-above", "0.5"}));
  EXPECT_EQ(easy.exit_code, 0);
  EXPECT_EQ(easy.err, "");
}

TEST(RunJudgement, WrongMapIsLost)
{
  const testing::ScratchFolder folder;
  const auto log = testing::simulated(folder.path(), "long", {"--set", "Simulation.duration_s=12"});
  const auto run = folder.path() / "run";
  const auto outcome =
      testing::localize({testing::shipped("landmark-localization", "long"), log.rawlog, "--map",
                         shuffledMap(log.map, folder.path() / "wrong.csv"), "--ground-truth", log.truth, "--set",
                         "LocalizationExperiment.initial_particles_count=2000", "--jobs", "2", "-q", "-o", run});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.out;
  const auto summary = testing::summaryOf(run);
  EXPECT_EQ(summary.at("verdict"), "lost");
  EXPECT_EQ(summary.at("success_rate"), 0.0);
  EXPECT_TRUE(summary.at("methods").at("particle_filter").at("position_error_m").at("rmse").is_null());
  EXPECT_TRUE(summary.at("methods").at("particle_filter").at("position_error_whole_run_m").at("rmse").is_number());
  EXPECT_GT(summary.at("filter").at("lost_steps"), 0);
}

TEST(RunJudgement, WrongMapIsNeverAnsweredWithASurePose)
{
  const testing::ScratchFolder folder;
  const auto log = testing::simulated(folder.path(), "tracking");
  const auto run = folder.path() / "run";
  const auto outcome =
      testing::localize({testing::shipped("landmark-localization", "tracking"), log.rawlog, "--map",
                         shuffledMap(log.map, folder.path() / "wrong.csv"), "--ground-truth", log.truth, "--set",
                         "LocalizationExperiment.initial_particles_count=2000", "--set",
                         "LocalizationExperiment.methods=particle_filter", "--jobs", "2", "-q", "-o", run});
  EXPECT_NE(testing::summaryOf(run).at("verdict"), "ok") << testing::summaryOf(run).at("verdict_reason");
  const Trajectory truth = readTum(log.truth);
  int sure_and_wrong = 0, steps = 0;
  for (const testing::StepRow& step : testing::stepsOf(run))
  {
    ++steps;
    sure_and_wrong += step.verdict == "ok" && testing::positionError(step, truth) > 1;
  }
  EXPECT_LT(sure_and_wrong, 0.05 * steps);
}
}  // namespace mrpt_ext::test_run_judgement
