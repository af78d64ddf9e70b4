#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "../importers/sample_data.h"
#include "mrpt_ext/app/apps.h"
#include "mrpt_ext/app/exit_codes.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/importers/mrclam.h"
#include "mrpt_ext/maps/register_all_classes.h"
#include "mrpt_ext/rawlog/rawlog_source.h"

namespace mrpt_ext::test_dataset_app
{
namespace
{
struct Outcome
{
  int exit_code = -1;
  std::string out, err;
};

Outcome runApp(const std::vector<std::string>& arguments)
{
  registerAllClasses();
  std::ostringstream out, err;
  const int exit_code = runDataset2Rawlog(arguments, out, err);
  return {exit_code, out.str(), err.str()};
}

Recording readBack(const std::filesystem::path& rawlog)
{
  RawlogSource source(rawlog);
  Recording recording;
  recording.records = readAll(source);
  return recording;
}

bool isOneLine(const std::string& text)
{
  return std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}
}  // namespace

TEST(DatasetApp, ReportsThatAShortRecordingCalibratesNothing)
{
  const testing::ScratchFolder folder;
  const auto ini = folder.write("a.ini", "[Sensor_a]\nstd_range_m = 1\n");
  const Outcome outcome =
      runApp({"cuhksz", testing::sampleFolder("cuhksz"), "-o", folder.path() / "c.rawlog", "--calibrate", ini});
  EXPECT_EQ(outcome.exit_code, kExitDone) << outcome.err;
  EXPECT_NE(outcome.out.find("radios: range biases not observable, fewer than ten epochs"), std::string::npos)
      << outcome.out;
  EXPECT_EQ(readTextFile(ini), "[Sensor_a]\nstd_range_m = 1\n");
  const Outcome missing = runApp({"cuhksz", testing::sampleFolder("cuhksz"), "-o", folder.path() / "d.rawlog",
                                  "--calibrate", folder.path() / "none.ini"});
  EXPECT_EQ(missing.exit_code, kExitFailed);
  EXPECT_EQ(missing.err, "--calibrate " + (folder.path() / "none.ini").string() + ": no such file\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "d.rawlog")) << "nothing is half done";
}

TEST(DatasetApp, ReadsABagAndTellsWhatItUsed)
{
  const testing::ScratchFolder folder;
  const std::filesystem::path bags = std::filesystem::path(MRPT_EXT_TEST_DATA) / "rosbag2";
  const auto bag = bags / "drive_zstd.mcap", map = bags / "landmarks.csv", rawlog = folder.path() / "bag.rawlog";
  const Outcome outcome =
      runApp({"rosbag2", bag, "--map", map, "--topic", "scan=none", "--topic", "detections=/objects", "-o", rawlog});
  EXPECT_EQ(outcome.exit_code, kExitDone) << outcome.err;
  EXPECT_NE(outcome.out.find("/odom (nav_msgs/msg/Odometry, 51 messages): odometry\n"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("/radio (sensor_msgs/msg/Range, 5 messages): ignored, other topics are asked for\n"),
            std::string::npos);
  EXPECT_EQ(testing::recordsOf<Reading>(readBack(rawlog)).size(), 5U);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "bag_ground_truth.tum"));
  EXPECT_EQ(readLandmarkCsv(folder.path() / "bag_map.csv").size(), 4U);

  const Outcome wrong = runApp({"rosbag2", bag, "--map", map, "--topic", "scan=/odom", "-o", rawlog});
  EXPECT_EQ(wrong.exit_code, kExitUsage);
  EXPECT_TRUE(isOneLine(wrong.err)) << wrong.err;
  EXPECT_EQ(runApp({"roh", bags, "--topic", "scan=/odom", "-o", rawlog}).exit_code, kExitUsage);
}

TEST(DatasetApp, WritesLogMapAndTruthThatReadBack)
{
  const testing::ScratchFolder folder;
  const auto sample = testing::sampleFolder("mrclam");
  const Outcome outcome = runApp({"mrclam", sample, "--robot", "1", "-o", folder.path() / "r1.rawlog"});
  EXPECT_EQ(outcome.exit_code, kExitDone) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("1 readings of unknown barcodes dropped"), std::string::npos);

  const Recording direct = importMrclam(sample, 1), read = readBack(folder.path() / "r1.rawlog");
  const auto expected = testing::recordsOf<Reading>(direct), readings = testing::recordsOf<Reading>(read);
  ASSERT_EQ(readings.size(), expected.size());
  for (std::size_t i = 0; i < readings.size(); ++i)
  {
    EXPECT_NEAR(readings[i].time, expected[i].time, 1e-6);
    ASSERT_EQ(readings[i].detections.size(), expected[i].detections.size());
    for (std::size_t k = 0; k < readings[i].detections.size(); ++k)
    {
      EXPECT_EQ(readings[i].detections[k].id, expected[i].detections[k].id);
      EXPECT_NEAR(*readings[i].detections[k].bearing, *expected[i].detections[k].bearing, 1e-6);
      EXPECT_NEAR(*readings[i].detections[k].range, *expected[i].detections[k].range, 1e-6);
      EXPECT_NEAR(readings[i].detections[k].std_range, kMrclamStdRange, 1e-6);
    }
  }
  EXPECT_EQ(testing::recordsOf<OdometryRecord>(read).size(), 4u);
  EXPECT_EQ(readLandmarkCsv(folder.path() / "r1_map.csv").size(), 3u);
  EXPECT_EQ(readTum(folder.path() / "r1_ground_truth.tum").size(), 3u);
}

TEST(DatasetApp, OptionsReachTheLog)
{
  const testing::ScratchFolder folder;
  const std::filesystem::path log = folder.path() / "s.rawlog";
  const Outcome outcome = runApp({"mrclam-snapshots", testing::sampleFolder("mrclam"), "--identity", "category",
                                  "--measurements", "bearing", "-q", "-o", log});
  EXPECT_EQ(outcome.exit_code, kExitDone) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const auto readings = testing::recordsOf<Reading>(readBack(log));
  ASSERT_EQ(readings.size(), 2u);
  EXPECT_EQ(readings[0].detections[0].id, kNoId);
  EXPECT_EQ(readings[0].detections[0].category, "barcode");
  EXPECT_FALSE(readings[0].detections[0].range);
}

TEST(DatasetApp, SameInputGivesTheSameBytes)
{
  const testing::ScratchFolder folder;
  for (const char* name : {"a.rawlog", "b.rawlog"})
    ASSERT_EQ(runApp({"roh", testing::sampleFolder("roh"), "-q", "-o", folder.path() / name}).exit_code, kExitDone);
  EXPECT_EQ(readTextFile(folder.path() / "a.rawlog"), readTextFile(folder.path() / "b.rawlog"));
  EXPECT_EQ(readTextFile(folder.path() / "a_ground_truth.tum"), readTextFile(folder.path() / "b_ground_truth.tum"));
}

TEST(DatasetApp, TruthOfAnEarlierConversionDoesNotStay)
{
  const testing::ScratchFolder folder;
  const testing::DamagedCopy copy("csv");
  const std::filesystem::path log = folder.path() / "c.rawlog", truth = folder.path() / "c_ground_truth.tum";
  ASSERT_EQ(runApp({"csv", copy.path(), "-q", "-o", log}).exit_code, kExitDone);
  ASSERT_TRUE(std::filesystem::exists(truth));
  copy.remove("ground_truth.tum");
  const Outcome outcome = runApp({"csv", copy.path(), "-q", "-o", log});
  EXPECT_EQ(outcome.exit_code, kExitDone);
  EXPECT_FALSE(std::filesystem::exists(truth));
  EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
}

TEST(DatasetApp, TruthHeadingOffTheMotionIsCorrectedWithAWarning)
{
  const testing::ScratchFolder folder;
  const testing::DamagedCopy copy("csv");
  std::string truth;
  for (int i = 0; i < 60; ++i)
    truth += std::to_string(i) + ".5 " + std::to_string(i) + " 0 0 0 0 0.7071068 0.7071068\n";
  copy.replace("ground_truth.tum", truth);
  copy.replace("odometry.csv", "t,v,omega_deg_s\n0,1,0\n60,0,0\n");
  std::filesystem::path log = folder.path() / "c.rawlog";
  const Outcome outcome = runApp({"csv", copy.path(), "-q", "-o", log});
  EXPECT_EQ(outcome.exit_code, kExitDone);
  EXPECT_NE(outcome.err.find("warning: the truth heading"), std::string::npos) << outcome.err;
  EXPECT_NEAR(readTum(folder.path() / "c_ground_truth.tum")[30].pose.phi, 0, 1e-6);
}

TEST(DatasetApp, WrongUsageIsOneLineAndExitCodeTwo)
{
  const std::string roh = testing::sampleFolder("roh"), mrclam = testing::sampleFolder("mrclam");
  const std::pair<std::vector<std::string>, std::string> cases[] = {
      {{"foo", roh, "-o", "a.rawlog"},
       "unknown format 'foo', expected one of csv cuhksz labyrinth mrclam mrclam-snapshots mrpt-kf-slam mrpt-ro-slam "
       "mrpt-uwb plaza roh"},
      {{"mrclm", roh, "-o", "a.rawlog"}, "did you mean mrclam?"},
      {{"roh"}, "INPUT is required"},
      {{"roh", roh}, "expected -o STEM.rawlog"},
      {{"roh", roh, "-o", "a.txt"}, "output 'a.txt', expected -o STEM.rawlog"},
      {{"roh", roh, roh, "-o", "a.rawlog"}, "roh: 2 inputs, expected folder"},
      {{"roh", roh, "--robot", "1", "-o", "a.rawlog"}, "expected no --robot"},
      {{"roh", roh, "--map", "m.csv", "-o", "a.rawlog"}, "expected no --map"},
      {{"roh", roh, "--set", "A.b=1", "-o", "a.rawlog"}, "--set A.b=1: dataset2rawlog has no configuration"},
      {{"roh", roh, "--measurements", "range", "-o", "a.rawlog"}, "no detection has a range"},
      {{"roh", roh, "--identity", "none", "-o", "a.rawlog"}, "--identity: none not in"},
      {{"mrclam", mrclam, "-o", "a.rawlog"}, "expected --robot with one of 1 2"},
      {{"mrclam", mrclam, "--robot", "3", "-o", "a.rawlog"}, "no robot 3, expected one of 1, 2"},
  };
  for (const auto& [arguments, message] : cases)
  {
    const Outcome outcome = runApp(arguments);
    EXPECT_EQ(outcome.exit_code, kExitUsage) << message;
    EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
  }
  EXPECT_FALSE(std::filesystem::exists("a.rawlog"));
}

TEST(DatasetApp, DamagedDataIsOneLineExitCodeOneAndNoFile)
{
  const testing::ScratchFolder folder;
  const testing::DamagedCopy copy("mrclam");
  copy.replace("Robot1_Measurement.dat", "1000.5 72 3.95\n");
  const std::filesystem::path log = folder.path() / "a.rawlog";
  const Outcome damaged = runApp({"mrclam", copy.path(), "--robot", "1", "-o", log});
  EXPECT_EQ(damaged.exit_code, kExitFailed);
  EXPECT_TRUE(isOneLine(damaged.err)) << damaged.err;
  EXPECT_NE(damaged.err.find("Robot1_Measurement.dat:1: 3 fields"), std::string::npos) << damaged.err;

  copy.replace("Robot1_Measurement.dat", "# nothing\n");
  const Outcome empty = runApp({"mrclam", copy.path(), "--robot", "1", "-q", "-o", log});
  EXPECT_EQ(empty.exit_code, kExitFailed);
  EXPECT_NE(empty.err.find("holds no reading"), std::string::npos) << empty.err;

  const Outcome unwritable = runApp({"roh", testing::sampleFolder("roh"), "-q", "-o", "/proc/none/a.rawlog"});
  EXPECT_EQ(unwritable.exit_code, kExitFailed);
  EXPECT_TRUE(isOneLine(unwritable.err)) << unwritable.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}
}  // namespace mrpt_ext::test_dataset_app
