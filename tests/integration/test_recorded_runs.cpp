#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "../importers/sample_data.h"
#include "mrpt_ext/files/text_file.h"
#include "scratch_folder.h"
#include "whole_runs.h"

// Whole runs of landmark-localization over real recordings. They are not part of the sources: the folder is named by
// LANDMARK_DATA_DIR, and a test skips where it is absent.
namespace mrpt_ext::test_recorded_runs
{
namespace
{
namespace fs = std::filesystem;
using testing::Arguments;

void expectMrclamRobotIsFound(const std::string& measurements)
{
  const fs::path recording = testing::recordingsFolder("mrclam/MRCLAM_Dataset6");
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is absent";
  const testing::ScratchFolder folder;
  const auto log =
      testing::imported(folder.path(), {"mrclam", recording, "--robot", "1", "--measurements", measurements});
  const auto summary = testing::summaryOf(testing::localized(folder.path(), "mrclam", log.arguments()));
  EXPECT_EQ(summary.at("success_rate"), 1.0) << summary.at("verdict_reason");
  EXPECT_LE(testing::positionRmse(summary), 0.40);
  // Dead reckoning alone is far off.
  EXPECT_GT(testing::positionRmse(summary, "odometry"), 3 * testing::positionRmse(summary));
}

/// Median position error of the closed forms over the snapshots of one MRCLAM data set.
void expectSnapshotMedian(int set, double reference)
{
  const fs::path recording = testing::recordingsFolder("mrclam/MRCLAM_Dataset" + std::to_string(set));
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is absent";
  const testing::ScratchFolder folder;
  const auto log = testing::imported(folder.path(), {"mrclam-snapshots", recording});
  const auto summary = testing::summaryOf(testing::localized(folder.path(), "mrclam-snapshots", log.arguments()));
  const double ml = testing::medianPositionError(summary, "bearing_maximum_likelihood");
  EXPECT_LE(ml, 1.1 * reference);
  EXPECT_GE(testing::medianPositionError(summary, "bearing_least_squares"), 0.9 * ml);
  EXPECT_GT(summary.at("methods").at("bearing_maximum_likelihood").at("availability"), 0.95);
  EXPECT_FALSE(summary.at("methods").contains("particle_filter")) << "frames that start lost have no filter";
}
}  // namespace

TEST(RecordedRun, MrptsLandmarkSlamDemo)
{
  const fs::path rawlog = "/usr/share/mrpt/datasets/kf-slam_demo.rawlog";
  if (!fs::exists(rawlog)) GTEST_SKIP() << rawlog << " is absent, it comes with mrpt-common";
  const testing::ScratchFolder folder;
  const auto log = testing::imported(folder.path(), {"mrpt-kf-slam", rawlog});
  const auto summary = testing::summaryOf(testing::localized(folder.path(), "mrpt-kf-slam-demo", log.arguments()));
  EXPECT_EQ(summary.at("success_rate"), 1.0) << summary.at("verdict_reason");
  EXPECT_EQ(summary.at("verdict"), "ok") << summary.at("verdict_reason");
  EXPECT_LE(testing::positionRmse(summary), 0.03);
}

TEST(RecordedRun, MrptsRangeOnlySlamDemo)
{
  const fs::path rawlog = "/usr/share/mrpt/datasets/RO-SLAM_demo.rawlog";
  if (!fs::exists(rawlog)) GTEST_SKIP() << rawlog << " is absent, it comes with mrpt-common";
  const testing::ScratchFolder folder;
  const auto log = testing::imported(folder.path(), {"mrpt-ro-slam", rawlog});
  const auto summary = testing::summaryOf(
      testing::localized(folder.path(), "mrpt-ro-slam-demo", {log.rawlog.string(), "--map", log.map.string()}));
  EXPECT_EQ(summary.at("verdict"), "ok") << summary.at("verdict_reason");
}

TEST(RecordedRun, CarParkFromRawScans)
{
  const fs::path recording = testing::recordingsFolder("carpark");
  if (!fs::exists(recording / "scans.csv.gz")) GTEST_SKIP() << recording << " is absent";
  const testing::ScratchFolder data, folder;
  for (const char* file : {"landmarks.csv", "ground_truth.tum", "scans.csv.gz"})
    fs::copy(recording / file, data.path() / file);
  fs::copy(recording / "speed_steering.csv", data.path() / "odometry.csv");
  static_cast<void>(data.write("sensors.csv",
                               "sensor,x,y,z,yaw_deg,first_bearing_deg,last_bearing_deg\nlaser,3.78,0.5,0,0,-90,90\n"));
  const auto log = testing::imported(
      folder.path(), {"csv", data.path(), "--wheelbase", "2.83", "--wheel-offset", "0.76", "--base", "laser"});
  const auto summary = testing::summaryOf(testing::localized(
      folder.path(), "reflectors", testing::joined(log.arguments(), {"--repeat", "5", "--jobs", "2"})));
  EXPECT_EQ(summary.at("success_rate"), 1.0);
  EXPECT_LE(testing::positionRmse(summary), 0.12);
}

TEST(RecordedRun, UwbDemo)
{
  const fs::path rawlog = "/usr/share/mrpt/datasets/uwb_ro-localization_demo.rawlog";
  if (!fs::exists(rawlog)) GTEST_SKIP() << rawlog << " is absent, it comes with mrpt-common";
  const testing::ScratchFolder folder;
  const auto summary =
      testing::summaryOf(testing::localized(folder.path(), "mrpt-uwb-demo", {"--repeat", "3", "--jobs", "2"}));
  EXPECT_EQ(summary.at("trials"), 3);
  EXPECT_EQ(summary.at("success_rate"), 1.0);
  EXPECT_LE(testing::positionRmse(summary), 0.15);
  EXPECT_GE(summary.at("filter").at("coverage_95"), 0.9);
  EXPECT_GT(summary.at("methods").at("range_least_squares").at("estimates"), 0);
  EXPECT_GT(summary.at("methods").at("running_fix").at("estimates"), 0);
  const auto& landmarks = summary.at("landmarks");
  ASSERT_EQ(landmarks.size(), 3U);
  for (const char* reliable : {"2", "3"})
    EXPECT_LT(landmarks.at("1").at("inlier_rate"), landmarks.at(reliable).at("inlier_rate").get<double>() - 0.1);
}

TEST(RecordedRun, Labyrinth)
{
  const fs::path recording = testing::recordingsFolder("labyrinth_uwb");
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is absent";
  const testing::ScratchFolder folder;
  const auto log = testing::imported(folder.path(), {"labyrinth", recording});
  const auto summary = testing::summaryOf(testing::localized(
      folder.path(), "labyrinth", testing::joined(log.arguments(), {"--repeat", "5", "--jobs", "2"})));
  EXPECT_EQ(summary.at("success_rate"), 1.0);
  for (const auto& trial : summary.at("trials_detail")) EXPECT_LE(trial.at("rmse"), 0.15);
  EXPECT_TRUE(summary.at("methods").at("particle_filter").at("heading_error_deg").at("rmse").is_null())
      << "the truth has no heading";
}

// The first minutes, in which one range after the other must tell mirror images apart.
TEST(RecordedRun, Plaza)
{
  const fs::path recording = testing::recordingsFolder("plaza");
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is absent";
  const testing::ScratchFolder folder;
  const testing::LogFiles log = testing::logFiles(folder.path(), "log");
  const auto import = testing::convert({"plaza", recording, "-q", "-o", log.rawlog});
  EXPECT_EQ(import.exit_code, 0);
  EXPECT_NE(import.err.find("Plaza1_TD.txt:1990: time goes back"), std::string::npos) << import.err;
  const auto summary = testing::summaryOf(
      testing::localized(folder.path(), "plaza",
                         testing::joined(log.arguments(), {"--repeat", "2", "--duration", "400", "--set",
                                                           "LocalizationExperiment.methods=particle_filter"})));
  EXPECT_EQ(summary.at("success_rate"), 1.0);
  for (const auto& trial : summary.at("trials_detail")) EXPECT_LE(trial.at("rmse"), 0.4);
}

// The shipped delays are those that the recording itself tells, without the truth.
TEST(RecordedRun, CuhkszDelaysAreTold)
{
  const fs::path recording = testing::recordingsFolder("cuhksz_uwb_planar");
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is absent";
  const testing::ScratchFolder folder;
  const fs::path shipped = testing::shipped("landmark-localization", "cuhksz"), again = folder.path() / "cuhksz.ini";
  fs::copy(shipped, again);
  (void)testing::imported(folder.path(), {"cuhksz", recording, "--calibrate", again});
  EXPECT_EQ(readTextFile(again), readTextFile(shipped));
}

// Three tags on one body tell its heading, without odometry.
TEST(RecordedRun, Cuhksz)
{
  const fs::path recording = testing::recordingsFolder("cuhksz_uwb_planar");
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is absent";
  const testing::ScratchFolder folder;
  const auto log = testing::imported(folder.path(), {"cuhksz", recording});
  const auto summary = testing::summaryOf(
      testing::localized(folder.path(), "cuhksz", testing::joined(log.arguments(), {"--duration", "20"})));
  EXPECT_EQ(summary.at("success_rate"), 1.0);
  EXPECT_LE(testing::positionRmse(summary), 0.08);
  EXPECT_LE(testing::positionRmse(summary, "kalman_filter_bank"), 0.08);
  EXPECT_FALSE(summary.at("methods").contains("running_fix")) << "there is no odometry";
  // The motion capture's body is turned by 7 deg against the tags.
  EXPECT_NEAR(summary.at("methods").at("particle_filter").at("heading_error_deg").at("median").get<double>(), 7, 4);
}

TEST(RecordedRun, MrclamRangesAndBearings) { expectMrclamRobotIsFound("range-bearing"); }
TEST(RecordedRun, MrclamBearings) { expectMrclamRobotIsFound("bearing"); }
TEST(RecordedRun, MrclamSnapshotsOfSet1) { expectSnapshotMedian(1, 0.049); }
TEST(RecordedRun, MrclamSnapshotsOfSet6) { expectSnapshotMedian(6, 0.103); }

TEST(RecordedRun, Roh)
{
  const fs::path recording = testing::recordingsFolder("roh_angulation");
  if (!fs::exists(recording)) GTEST_SKIP() << recording << " is absent";
  const testing::ScratchFolder folder;
  const auto log = testing::imported(folder.path(), {"roh", recording});
  const auto summary = testing::summaryOf(testing::localized(folder.path(), "roh", log.arguments()));
  EXPECT_LE(testing::medianPositionError(summary, "bearing_maximum_likelihood"), 0.10);
  EXPECT_EQ(summary.at("methods").at("bearing_maximum_likelihood").at("availability"), 1);
  EXPECT_TRUE(summary.at("methods").at("bearing_maximum_likelihood").at("heading_error_deg").at("rmse").is_null())
      << "headings are not judged";
}
}  // namespace mrpt_ext::test_recorded_runs
