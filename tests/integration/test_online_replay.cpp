#include <gtest/gtest.h>

#include <deque>

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

/// With changes of the configuration, "Section.key=value" each. Every third reading comes `delay` [s] late.
std::string onlineSteps(const fs::path& ini, const LogFiles& files, const std::vector<std::string>& changes,
                        double delay = 0)
{
  const LandmarkTable map = readLandmarkCsv(files.map);
  const Settings settings = Settings::load(ini, localizationKeys(), changes);
  OnlineLocalizer robot(onlineOptions(localizationConfig(settings, map)), map);
  RunRecord run;
  run.methods.push_back({.name = "particle_filter", .continuous = true});
  const auto keep = [&](const std::vector<OnlineEstimate>& estimates)
  {
    for (const OnlineEstimate& estimate : estimates)
      if (estimate.best) run.methods[0].points.push_back(*estimate.best);
  };
  RawlogSource source(files.rawlog);
  std::deque<Record> late;  // every third reading
  std::size_t readings = 0;
  const auto add = [&](Record record)
  {
    robot.add(std::move(record));
    keep(robot.estimates());
  };
  while (auto record = source.next())
  {
    for (; !late.empty() && timeOf(late.front()) + delay <= timeOf(*record); late.pop_front())
      add(std::move(late.front()));
    if (delay > 0 && std::holds_alternative<Reading>(*record) && readings++ % 3 == 0)
      late.push_back(std::move(*record));
    else
      add(std::move(*record));
  }
  for (Record& record : late) add(std::move(record));
  keep(robot.finish());
  std::string text;
  stepsCsv(run, [&](std::string_view line) { text += line; });
  return text;
}

class OnlineReplay : public ::testing::Test
{
 protected:
  void expectSameSteps(const std::string& name, const LogFiles& files, const std::vector<std::string>& changes = {},
                       double delay = 0)
  {
    Arguments arguments = testing::joined(files.arguments(), kFilterAlone);
    for (const std::string& change : changes) arguments = testing::joined(arguments, {"--set", change});
    const fs::path run = testing::localized(folder_.path(), name, arguments);
    const std::string of_app = readTextFile(run / "steps.csv");
    EXPECT_GT(of_app.size(), 5000U);
    EXPECT_TRUE(of_app == onlineSteps(testing::shipped("landmark-localization", name), files, changes, delay)) << name;
  }

  testing::ScratchFolder folder_;
};

LogFiles shippedLog(const std::string& name)
{
  return testing::logFiles(fs::path(MRPT_EXT_SOURCE_DIR) / "datasets", name);
}
}  // namespace

TEST_F(OnlineReplay, Room) { expectSameSteps("room", shippedLog("room")); }
TEST_F(OnlineReplay, RoomWithEveryThirdReadingLate)
{
  expectSameSteps("room", shippedLog("room"), {"LocalizationExperiment.lateness_s=0.6"}, 0.5);
}
TEST_F(OnlineReplay, HalfField) { expectSameSteps("half-field", shippedLog("half-field")); }
TEST_F(OnlineReplay, GoalCornersWithRunningFixes) { expectSameSteps("goal-corners", shippedLog("goal-corners")); }
TEST_F(OnlineReplay, Kidnapping) { expectSameSteps("kidnap", testing::simulated(folder_.path(), "kidnap")); }
TEST_F(OnlineReplay, Tracking) { expectSameSteps("tracking", testing::simulated(folder_.path(), "tracking")); }

// Scans overlap: each begins before the frame of the one before, whose odometry must not be forgotten by then.
TEST_F(OnlineReplay, ScansOfASpinningScanner)
{
  const LogFiles log = testing::simulated(folder_.path(), "tracking",
                                          {"--set", "Odometry.rate_hz=100", "--set", "Sensor_camera.rate_hz=20",
                                           "--set", "Sensor_camera.scan_duration_s=0.1"});
  expectSameSteps("tracking", log, {"Sensor_camera.scan_duration_s=0.1"});
}
}  // namespace mrpt_ext
