#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/files/tum.h"
#include "scratch_folder.h"
#include "summary_schema.h"
#include "whole_runs.h"

// What a run leaves: names of files, columns and keys that scripts rely on.
namespace mrpt_ext::test_run_files
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::Arguments;

std::set<std::string> namesIn(const fs::path& folder)
{
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

std::string header(const fs::path& file)
{
  const std::string text = readTextFile(file);
  return text.substr(0, text.find('\n'));
}

using Keys = std::set<std::string>;

void expectSchema1(const fs::path& run)
{
  testing::expectSchema1(nlohmann::ordered_json::parse(readTextFile(run / "summary.json")));
}

const Arguments kBrief{"--duration", "20"};
}  // namespace

TEST(RunFiles, OneRun)
{
  const testing::ScratchFolder folder;
  const auto run = testing::localized(
      folder.path(), "half-field", testing::joined(kBrief, {"--set", "LocalizationExperiment.save_final_scene=true"}));
  const Json summary = testing::summaryOf(run);
  expectSchema1(run);
  EXPECT_EQ(summary.at("trials"), 1);
  EXPECT_EQ(summary.at("landmarks").size(), 2U);
  EXPECT_EQ(summary.at("filter").at("modes_at_end").at(0).size(), 4U);

  Keys expected{"summary.json",        "report.html", "steps.csv",   "hypotheses.csv",
                "config_resolved.ini", "log.txt",     "objects.csv", "final.3Dscene"};
  for (const std::string& method : testing::keysOf(summary.at("methods")))
    expected.insert("trajectory_" + method + ".tum");
  EXPECT_EQ(namesIn(run), expected) << "nothing is missing, and no temporary file is left";
  for (const std::string& name : expected) EXPECT_GT(fs::file_size(run / name), 0U) << name;

  EXPECT_EQ(header(run / "steps.csv"), "t,method,x,y,phi_deg,cxx,cxy,cyy,cpp,modes,w_best,ess,verdict");
  EXPECT_EQ(header(run / "hypotheses.csv"), "t,rank,x,y,phi_deg,weight,source");
  EXPECT_EQ(header(run / "objects.csv"), "t,label,x,y,cxx,cxy,cyy,x_robot,y_robot");
  for (const char* table : {"steps.csv", "hypotheses.csv", "objects.csv"})
    EXPECT_GT(TextTable(run / table, {}).size(), 10U) << table;
  EXPECT_EQ(readTum(run / "trajectory_particle_filter.tum").size(), testing::stepsOf(run).size());
}

TEST(RunFiles, FiguresThatDoNotExistAreNull)
{
  const testing::ScratchFolder folder;
  // Positions from ranges have no heading.
  const auto truth = testing::summaryOf(testing::localized(folder.path(), "half-field", kBrief)).at("methods");
  EXPECT_TRUE(truth.at("range_least_squares").at("position_error_m").at("rmse").is_number());
  for (const auto& [name, figure] : truth.at("range_least_squares").at("heading_error_deg").items())
    EXPECT_TRUE(figure.is_null()) << name;

  const auto run =
      testing::localized(folder.path(), "half-field",
                         testing::joined(kBrief, {"--set", "LocalizationExperiment.ground_truth_path_file="}));
  const Json blind = testing::summaryOf(run);
  expectSchema1(run);
  EXPECT_EQ(blind.at("verdict"), "ok") << "the verdict needs no truth";
  EXPECT_TRUE(blind.at("success_rate").is_null());
  EXPECT_TRUE(blind.at("trials_detail").at(0).at("success").is_null());
  EXPECT_TRUE(blind.at("trials_detail").at(0).at("rmse").is_null());
  EXPECT_TRUE(blind.at("filter").at("nees").at("mean").is_null());
  for (const Json& method : blind.at("methods"))
    for (const char* errors : {"position_error_m", "heading_error_deg", "position_error_whole_run_m"})
      for (const auto& [name, figure] : method.at(errors).items()) EXPECT_TRUE(figure.is_null()) << name;
}

TEST(RunFiles, ResolvedConfigurationRunsAgain)
{
  const testing::ScratchFolder folder;
  const auto run = testing::localized(folder.path(), "half-field", kBrief);
  const auto again = folder.path() / "again";
  const auto outcome = testing::localize(testing::joined({run / "config_resolved.ini", "-q", "-o", again}, kBrief));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(readTextFile(again / "steps.csv"), readTextFile(run / "steps.csv"));
}

TEST(RunFiles, RepeatedRuns)
{
  const testing::ScratchFolder folder;
  const auto run = testing::localized(folder.path(), "half-field", testing::joined(kBrief, {"--repeat", "2"}));
  EXPECT_EQ(namesIn(run),
            (Keys{"trial_000", "trial_001", "summary.json", "report.html", "config_resolved.ini", "log.txt"}));
  const Json merged = testing::summaryOf(run);
  expectSchema1(run);
  EXPECT_EQ(merged.at("trials"), 2);
  ASSERT_EQ(merged.at("trials_detail").size(), 2U);
  double sum = 0;
  for (const char* trial : {"trial_000", "trial_001"})
  {
    const Json summary = testing::summaryOf(run / trial);
    expectSchema1(run / trial);
    EXPECT_EQ(summary.at("trials"), 1);
    sum += testing::positionRmse(summary);
    const Keys names = namesIn(run / trial);
    for (const char* name : {"summary.json", "report.html", "steps.csv", "hypotheses.csv", "objects.csv",
                             "trajectory_particle_filter.tum"})
      EXPECT_TRUE(names.contains(name)) << trial << '/' << name;
  }
  EXPECT_NEAR(testing::positionRmse(merged), sum / 2, 1e-12) << "each figure is the median over the trials";

  const auto fewer = testing::localize(
      testing::joined({testing::shipped("landmark-localization", "half-field"), "-o", run, "--repeat", "1"}, kBrief));
  EXPECT_EQ(fewer.exit_code, 0) << fewer.err;
  EXPECT_NE(fewer.out.find("holds 1 more trial of earlier runs (trial_001), which localization-report counts as well"),
            std::string::npos)
      << fewer.out;
}

TEST(RunFiles, DryRunWritesNothing)
{
  const testing::ScratchFolder folder;
  const auto outcome =
      testing::localize({testing::shipped("landmark-localization", "room"), "--dry-run", "-o", folder.path() / "none"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("451 CObservationLandmarkBearings"), std::string::npos) << outcome.out;
  EXPECT_TRUE(fs::is_empty(folder.path()));
}
}  // namespace mrpt_ext::test_run_files
