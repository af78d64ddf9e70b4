#include <gtest/gtest.h>

#include <deque>
#include <sstream>

#include "../importers/sample_data.h"
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

/// The first line in which two texts differ, and what stands there; empty where they are the same.
std::string firstDifference(const std::string& a, const std::string& b)
{
  std::istringstream left(a), right(b);
  for (int number = 1;; ++number)
  {
    std::string one, other;
    const bool more = bool(std::getline(left, one)), also = bool(std::getline(right, other));
    if (!more && !also) return {};
    if (more != also || one != other) return "line " + std::to_string(number) + ": " + one + "\n" + other;
  }
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
    const fs::path ini = testing::shipped("landmark-localization", name);
    EXPECT_EQ(firstDifference(of_app, onlineSteps(ini, files, changes, delay)), "") << name;
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

TEST_F(OnlineReplay, MrptsUwbDemo)
{
  const fs::path rawlog = "/usr/share/mrpt/datasets/uwb_ro-localization_demo.rawlog";
  if (!fs::exists(rawlog)) GTEST_SKIP() << rawlog << " is absent, it comes with mrpt-common";
  const fs::path map =
      testing::shipped("landmark-localization", "mrpt-uwb-demo").replace_filename("mrpt-uwb-demo_map.csv");
  expectSameSteps("mrpt-uwb-demo", {rawlog, map, {}});
}

// Real recordings, whose folder is named by LANDMARK_DATA_DIR.
TEST_F(OnlineReplay, CarPark)
{
  const fs::path recording = testing::recordingsFolder("carpark");
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is absent";
  const testing::ScratchFolder data;
  for (const char* file : {"landmarks.csv", "ground_truth.tum", "detections.csv", "odometry.csv"})
    fs::copy(recording / file, data.path() / file);
  expectSameSteps("csv", testing::imported(folder_.path(), {"csv", data.path()}));
}
TEST_F(OnlineReplay, MrclamWithoutNames)
{
  const fs::path recording = testing::recordingsFolder("mrclam/MRCLAM_Dataset6");
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is absent";
  expectSameSteps("mrclam",
                  testing::imported(folder_.path(), {"mrclam", recording, "--robot", "1", "--identity", "anonymous"}));
}
TEST_F(OnlineReplay, Plaza)
{
  const fs::path recording = testing::recordingsFolder("plaza");
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is absent";
  expectSameSteps("plaza", testing::imported(folder_.path(), {"plaza", recording}));
}
}  // namespace mrpt_ext
