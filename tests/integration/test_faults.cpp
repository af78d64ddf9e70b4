#include <gtest/gtest.h>

#include "mrpt_ext/files/atomic_file.h"
#include "mrpt_ext/files/folder_lock.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"
#include "mrpt_ext/rawlog/sha256.h"
#include "scratch_folder.h"
#include "whole_runs.h"

// Inputs that once made the program crash, hang, overwrite or mix something up.
namespace mrpt_ext::test_faults
{
namespace
{
namespace fs = std::filesystem;
using testing::AppOutcome;
using testing::Arguments;
using testing::localize;
using testing::ScratchFolder;

const fs::path kRoom = testing::shipped("landmark-localization", "room");
const Arguments kBrief{"--duration", "3",
                       "--set",      "LocalizationExperiment.particles_count=100",
                       "--set",      "LocalizationExperiment.initial_particles_count=500",
                       "--set",      "LocalizationExperiment.methods=particle_filter"};

fs::path faulty(const std::string& name) { return fs::path(MRPT_EXT_TEST_DATA) / "faults" / name; }
fs::path dataset(const std::string& name) { return fs::path(MRPT_EXT_SOURCE_DIR) / "datasets" / name; }

/// One line on stderr that holds `text`, and the exit code.
void expectRefused(const AppOutcome& outcome, int exit_code, const std::string& text)
{
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_NE(outcome.err.find(text), std::string::npos) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

/// A log of a robot that stands still, with one frame of so many detections.
fs::path logOfDetections(const fs::path& folder, std::size_t count)
{
  Recording recording;
  recording.records.emplace_back(OdometryRecord{});
  Reading reading;
  reading.time = 1;
  reading.sensor = "omni";
  for (std::size_t i = 0; i < count; ++i)
    reading.detections.push_back({.bearing = wrap(0.001 * static_cast<double>(i)), .std_bearing = 0.01});
  recording.records.emplace_back(reading);
  writeRawlog(folder / "many.rawlog", recording);
  return folder / "many.rawlog";
}
}  // namespace

TEST(Faults, ASecondRunIntoTheSameFolderIsRefused)
{
  const ScratchFolder folder;
  const Arguments run = testing::joined({kRoom, "-q", "-o", folder.path()}, kBrief);
  {
    const FolderLock other_program(folder.path());
    expectRefused(localize(run), 1, "another program is writing into it");
    EXPECT_TRUE(fs::is_empty(folder.path()));
  }
  EXPECT_EQ(localize(run).exit_code, 0);
}

TEST(Faults, DamagedLogsAreRefusedWithTheirRecord)
{
  const ScratchFolder folder;
  const auto run = [&](const std::string& log) { return localize({kRoom, faulty(log), "-o", folder.path() / "run"}); };
  expectRefused(run("crash_odometry_1e308.rawlog"), 1, "record 3: odometry at 1e+308 m");
  expectRefused(run("hang_future_stamp_room.rawlog"), 1, "record 38: time 9.10693e+11 s");
  expectRefused(run("hang_future_stamp_goal-corners_100y.rawlog"), 1, "days after that of an earlier record");
  expectRefused(run("memory_2.3GB.rawlog"), 1, "states a length of more bytes than the log has left");
  expectRefused(run("memory_4.2GB.rawlog"), 1, "states a length of more bytes than the log has left");
  expectRefused(run("multiline_abstract_class.rawlog"), 1, ": record ");
  expectRefused(run("ubsan_bool.rawlog"), 1, "expected 0 or 1");
  EXPECT_FALSE(fs::exists(folder.path() / "run"));
}

TEST(Faults, MapsBeyondTheEarthAreRefusedWithTheirLine)
{
  for (const std::string map : {"ubsan_svg_map.csv", "vector_max_size_map.csv"})
    expectRefused(localize({kRoom, "--map", faulty(map)}), 1,
                  map + ":2: '1e308' is not within 1e+08 either way, expected x");
}

TEST(Faults, LimitsNameTheirKey)
{
  const ScratchFolder folder;
  expectRefused(
      localize({kRoom, logOfDetections(folder.path(), 2001), "-o", folder.path() / "run"}), 1,
      "frame at 1.000 s: 2001 detections, expected at most 2000: set [LocalizationExperiment] max_detections");
  expectRefused(localize({kRoom, "--set", "LocalizationExperiment.max_landmarks=5"}), 1,
                "room_map.csv:7: more than 5 rows, expected no more: set [LocalizationExperiment] max_landmarks");
  expectRefused(localize({kRoom, "--set", "LocalizationExperiment.particles_count=100000000"}), 2,
                "expected a whole number in [1, 1e+07]");
}

TEST(Faults, NumbersBeyondAnyMeaningAreRefused)
{
  expectRefused(localize({kRoom, "--set", "LocalizationExperiment.init_PDF_max_x=1e308"}), 2,
                "init_PDF_max_x=1e308: expected a number m, and none beyond 1e+09");
}

TEST(Faults, AHugeIniIsRefused)
{
  const ScratchFolder folder;
  std::string ini;
  for (int i = 0; i < 20'000; ++i) ini += "[Sensor_" + std::to_string(i) + "]\n";
  expectRefused(localize({folder.write("huge.ini", ini)}), 2, "huge.ini:1001: [Sensor_1000] is one section too many");
}

TEST(Faults, ALogIsNotCalibrated)
{
  const ScratchFolder folder;
  const fs::path log = folder.path() / "precious.rawlog";
  fs::copy_file(dataset("room.rawlog"), log);
  expectRefused(localize({kRoom, "--calibrate", log}), 2, "precious.rawlog: only a configuration (.ini)");
  EXPECT_EQ(sha256OfFile(log), sha256OfFile(dataset("room.rawlog"))) << "it was overwritten";
}

TEST(Faults, ControlCharactersDoNotReachTheTerminal)
{
  const ScratchFolder folder;
  const AppOutcome wrong = localize({folder.write("my.ini", "[\x1b[2J\x07]\n")});
  expectRefused(wrong, 2, "unknown section [\\x1b[2J\\x07]");
  const AppOutcome line = localize({kRoom, "--map", folder.write("map.csv", "id,x,y\n\x1b]0;title\x07,1,2\n")});
  expectRefused(line, 1, "map.csv:2: '\\x1b]0;title\\x07' is not an integer");
}

TEST(Faults, ResumeTakesOnlyTrialsOfTheSameInputs)
{
  const ScratchFolder folder;
  const std::string out = folder.path() / "run";
  const fs::path map = folder.write("map.csv", readTextFile(dataset("room_map.csv")));
  const auto run = [&](const Arguments& more) {
    return localize(testing::joined(testing::joined({kRoom, "--repeat", "2", "--map", map, "-o", out}, kBrief), more));
  };
  EXPECT_NE(run({}).exit_code, 1);
  EXPECT_NE(run({"--resume"}).out.find("resumed  2 of 2"), std::string::npos);

  // A run of other settings that was cut off after its first trial.
  const std::string other = readTextFile(fs::path(out) / "trial_001/summary.json");
  EXPECT_NE(run({"--set", "LocalizationExperiment.converged_within_m=0.4"}).exit_code, 1);
  writeFileAtomically(fs::path(out) / "trial_001/summary.json", other);
  EXPECT_NE(run({"--set", "LocalizationExperiment.converged_within_m=0.4", "--resume"}).out.find("resumed  1 of 2"),
            std::string::npos);

  writeFileAtomically(map, readTextFile(map) + "99,1,1,0,edge\n");
  const AppOutcome edited = run({"--set", "LocalizationExperiment.converged_within_m=0.4", "--resume"});
  EXPECT_EQ(edited.out.find("resumed"), std::string::npos) << edited.out;
  expectRefused(localize(testing::joined({kRoom, "--repeat", "2", "-o", out, "--resume"}, kBrief)), 2,
                "has other settings");
}

TEST(Faults, AReportOfALargeMapStaysSmall)
{
  const ScratchFolder folder;
  std::string map = "id,x,y,category\n";
  for (int i = 0; i < 60'000; ++i)
    map += std::to_string(i) + "," + std::to_string(i % 245 * 0.04) + "," + std::to_string(i / 245 * 0.03) + ",far\n";
  const fs::path run = folder.path() / "run";
  const AppOutcome outcome = localize(testing::joined(
      {kRoom, "--map", folder.write("map.csv", map), "-o", run, "--set", "LocalizationExperiment.methods=odometry"},
      {"--duration", "3"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_LT(fs::file_size(run / "report.html"), 5'000'000U);
}
}  // namespace mrpt_ext::test_faults
