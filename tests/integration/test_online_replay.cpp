#include <gtest/gtest.h>

#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/maps/register_all_classes.h"
#include "mrpt_ext/online/online_localizer.h"
#include "mrpt_ext/rawlog/rawlog_source.h"
#include "mrpt_ext/report/run_csv.h"
#include "scratch_folder.h"
#include "whole_runs.h"

// A log that is fed to OnlineLocalizer record by record gives the bytes of the app's steps.csv.
namespace mrpt_ext
{
namespace
{
namespace fs = std::filesystem;
using testing::Arguments;
using testing::LogFiles;

const Arguments kFilterAlone{"--set", "LocalizationExperiment.methods=particle_filter"};

std::string onlineSteps(const fs::path& ini, const LogFiles& files)
{
  const LandmarkTable map = readLandmarkCsv(files.map);
  OnlineLocalizer robot(onlineOptions(localizationConfig(Settings::load(ini, localizationKeys()), map)), map);
  RunRecord run;
  run.methods.push_back({.name = "particle_filter", .continuous = true});
  const auto keep = [&](const std::vector<OnlineEstimate>& estimates)
  {
    for (const OnlineEstimate& estimate : estimates)
      if (estimate.best) run.methods[0].points.push_back(*estimate.best);
  };
  RawlogSource source(files.rawlog);
  while (auto record = source.next())
  {
    robot.add(std::move(*record));
    keep(robot.estimates());
  }
  keep(robot.finish());
  std::string text;
  stepsCsv(run, [&](std::string_view line) { text += line; });
  return text;
}

class OnlineReplay : public ::testing::Test
{
 protected:
  void expectSameSteps(const std::string& name, const LogFiles& files)
  {
    const fs::path run = testing::localized(folder_.path(), name, testing::joined(files.arguments(), kFilterAlone));
    const std::string of_app = readTextFile(run / "steps.csv");
    EXPECT_GT(of_app.size(), 5000U);
    EXPECT_TRUE(of_app == onlineSteps(testing::shipped("landmark-localization", name), files)) << name;
  }

  testing::ScratchFolder folder_;
};

LogFiles shippedLog(const std::string& name)
{
  return testing::logFiles(fs::path(MRPT_EXT_SOURCE_DIR) / "datasets", name);
}
}  // namespace

TEST_F(OnlineReplay, Room) { expectSameSteps("room", shippedLog("room")); }
TEST_F(OnlineReplay, HalfField) { expectSameSteps("half-field", shippedLog("half-field")); }
TEST_F(OnlineReplay, GoalCornersWithRunningFixes) { expectSameSteps("goal-corners", shippedLog("goal-corners")); }
TEST_F(OnlineReplay, Kidnapping) { expectSameSteps("kidnap", testing::simulated(folder_.path(), "kidnap")); }
TEST_F(OnlineReplay, Tracking) { expectSameSteps("tracking", testing::simulated(folder_.path(), "tracking")); }
}  // namespace mrpt_ext
