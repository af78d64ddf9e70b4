#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "../importers/sample_data.h"
#include "mrpt_ext/app/exit_codes.h"
#include "mrpt_ext/app/live_messages.h"
#include "mrpt_ext/app/live_run.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/maps/register_all_classes.h"
#include "mrpt_ext/online/online_localizer.h"
#include "mrpt_ext/rawlog/rawlog_source.h"
#include "mrpt_ext/report/csv_field.h"
#include "mrpt_ext/report/run_csv.h"
#include "scratch_folder.h"
#include "test_length.h"
#include "whole_runs.h"

// A log that is fed to OnlineLocalizer record by record, or to --live line by line, gives the bytes of the app's
// steps.csv.
namespace mrpt_ext::test_online_replay
{
namespace
{
namespace fs = std::filesystem;
using testing::Arguments;
using testing::LogFiles;
using Json = nlohmann::json;

const Arguments kFilterAlone{"--set", "LocalizationExperiment.methods=particle_filter"};

/// The records of a log as a robot may get them: every third reading comes `delay` [s] late.
void forEachAsItComes(const fs::path& rawlog, double delay, const std::function<void(Record)>& add)
{
  RawlogSource source(rawlog);
  std::deque<Record> late;
  std::size_t readings = 0;
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
}

/// With changes of the configuration, "Section.key=value" each.
std::string onlineSteps(const fs::path& ini, const LogFiles& files, const std::vector<std::string>& changes,
                        double delay)
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
  forEachAsItComes(files.rawlog, delay,
                   [&](Record record)
                   {
                     robot.add(std::move(record));
                     keep(robot.estimates());
                   });
  keep(robot.finish());
  std::string text;
  stepsCsv(run, [&](std::string_view line) { text += line; });
  return text;
}

/// A line of --live as the row of steps.csv, as far as it says what stands there.
std::string stepOf(const Json& line)
{
  const bool heading_known = !line["phi_deg"].is_null();
  const auto covariance = [&](int k) { return ',' + covarianceField(line["covariance"][k]); };
  return timeField(line["t"]) + ",particle_filter," + lengthField(line["x"]) + ',' + lengthField(line["y"]) + ',' +
         (heading_known ? fixedText(line["phi_deg"], kAngleDecimals) : "") + covariance(0) + covariance(1) +
         covariance(3) + (heading_known ? covariance(5) : ",") + ',' + line["verdict"].get<std::string>() + '\n';
}

std::string liveSteps(const fs::path& ini, const LogFiles& files, std::vector<std::string> changes, double delay)
{
  std::stringstream lines, answers;
  forEachAsItComes(files.rawlog, delay,
                   [&](const Record& record)
                   {
                     const auto line = liveLineOf(record);
                     if (line) lines << *line << '\n';
                   });
  changes.push_back("MetricMap_landmarkMap2D_00_creationOpts.landmarks_file=" + files.map.string());
  EXPECT_NE(runLive(Settings::load(ini, localizationKeys(), changes), lines, answers), kExitFailed);
  std::string rows;
  for (std::string text; std::getline(answers, text);)
    if (const Json line = Json::parse(text); line.contains("x")) rows += stepOf(line);
  return rows;
}

/// Rows of steps.csv without what --live does not tell: modes, w_best, ess.
std::string toldLive(const std::string& steps)
{
  return std::regex_replace(steps.substr(steps.find('\n') + 1), std::regex("(,[^,\n]*){3}(,[^,\n]*\n)"), "$2");
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

const std::string kMayBeLate = "LocalizationExperiment.lateness_s=0.6";
constexpr double kLate = 0.5;  // [s]

class OnlineReplay : public ::testing::Test
{
 protected:
  using Changes = std::vector<std::string>;

  /// steps.csv of a run of the app.
  std::string stepsOfApp(const std::string& name, const LogFiles& files, const Changes& changes)
  {
    Arguments arguments = testing::joined(files.arguments(), kFilterAlone);
    for (const std::string& change : changes) arguments = testing::joined(arguments, {"--set", change});
    std::string steps = readTextFile(testing::localized(folder_.path(), name, arguments) / "steps.csv");
    EXPECT_GT(steps.size(), 5000U);
    return steps;
  }

  /// Through OnlineLocalizer, and through --live in order and with every third reading late.
  void expectSameSteps(const std::string& name, const LogFiles& files, const Changes& changes = {})
  {
    const std::string of_app = stepsOfApp(name, files, changes), told = toldLive(of_app);
    const fs::path ini = testing::shipped("landmark-localization", name);
    if (!testing::isShort())
    {
      EXPECT_EQ(firstDifference(of_app, onlineSteps(ini, files, changes, 0)), "") << name;
      EXPECT_EQ(firstDifference(told, liveSteps(ini, files, changes, 0)), "") << name;
    }
    const Changes tolerant = testing::joined(changes, {kMayBeLate});
    EXPECT_EQ(firstDifference(told, liveSteps(ini, files, tolerant, kLate)), "") << name << ", late";
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
  const fs::path ini = testing::shipped("landmark-localization", "room");
  const std::string of_app = stepsOfApp("room", shippedLog("room"), {kMayBeLate});
  EXPECT_EQ(firstDifference(of_app, onlineSteps(ini, shippedLog("room"), {kMayBeLate}, kLate)), "");
}
TEST_F(OnlineReplay, HalfField) { expectSameSteps("half-field", shippedLog("half-field")); }
TEST_F(OnlineReplay, GoalCornersWithRunningFixes)
{
  const fs::path ini = testing::shipped("landmark-localization", "goal-corners");
  const std::string of_app = stepsOfApp("goal-corners", shippedLog("goal-corners"), {});
  EXPECT_EQ(firstDifference(of_app, onlineSteps(ini, shippedLog("goal-corners"), {}, 0)), "");
}
TEST_F(OnlineReplay, LinesAreWrittenOfALog)
{
  const testing::AppOutcome lines =
      testing::localize({testing::shipped("landmark-localization", "goal-corners"), "--lines"});
  EXPECT_EQ(lines.exit_code, 0);
  std::string expected;
  std::size_t left_out = 0;
  RawlogSource source(shippedLog("goal-corners").rawlog);
  while (const auto record = source.next())
    if (const auto line = liveLineOf(*record))
      expected += *line + '\n';
    else
      ++left_out;
  EXPECT_EQ(firstDifference(lines.out, expected), "");
  EXPECT_GT(left_out, 0U) << "running fixes";
  EXPECT_NE(lines.err.find("note: " + std::to_string(left_out) + " records left out"), std::string::npos) << lines.err;
}
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
}  // namespace mrpt_ext::test_online_replay
