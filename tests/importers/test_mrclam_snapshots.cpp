#include "mrpt_ext/importers/mrclam_snapshots.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/geometry/input_error.h"
#include "sample_data.h"

namespace mrpt_ext::test_mrclam_snapshots
{
using testing::DamagedCopy;
using testing::hasNote;
using testing::recordsOf;

TEST(MrclamSnapshots, AveragesInliersOfOneLandmarkAlsoAcrossPi)
{
  const Recording recording = importMrclamSnapshots(testing::sampleFolder("mrclam"));
  const auto readings = recordsOf<Reading>(recording);
  ASSERT_EQ(readings.size(), 2u);
  EXPECT_EQ(readings[0].time, 1.0);
  EXPECT_EQ(readings[1].time, 3.0);
  ASSERT_EQ(readings[0].detections.size(), 3u);
  EXPECT_EQ(readings[0].detections[0].id, 6);
  EXPECT_NEAR(*readings[0].detections[0].range, 4.1, 1e-12);
  EXPECT_NEAR(std::abs(wrap(*readings[0].detections[0].bearing - kPi)), 0, 1e-9);
  EXPECT_EQ(*readings[0].detections[2].range, 4.0);
  ASSERT_EQ(recording.truth.size(), 2u);
  EXPECT_EQ(recording.truth[0].time, 1.0);
  EXPECT_EQ(recording.truth[0].pose.phi, 3.14);
  EXPECT_TRUE(recordsOf<OdometryRecord>(recording).empty());
}

TEST(MrclamSnapshots, CountsWhatIsDropped)
{
  const Recording recording = importMrclamSnapshots(testing::sampleFolder("mrclam"));
  EXPECT_TRUE(hasNote(recording, "11 rows of readings"));
  EXPECT_TRUE(hasNote(recording, "1 readings marked as outliers dropped"));
  EXPECT_TRUE(hasNote(recording, "2 readings averaged"));
  EXPECT_TRUE(hasNote(recording, "1 snapshots with fewer than 3 distinct landmarks dropped"));
  const Recording one_robot = importMrclamSnapshots(testing::sampleFolder("mrclam"), 2);
  EXPECT_EQ(one_robot.records.size(), 1u);
  EXPECT_TRUE(hasNote(one_robot, "2 snapshots of other robots dropped"));
}

TEST(MrclamSnapshots, DamagedFilesAreNamedWithTheirLine)
{
  const DamagedCopy copy("mrclam");
  const std::string header = "snapshot,robot,t,subject,range_m,bearing_rad,inlier,gt_x_m,gt_y_m,gt_theta_rad\n";
  const auto import = [&] { (void)importMrclamSnapshots(copy.path()); };
  copy.replace("Snapshots.csv", header + "1,1,5,6,4,0,1,0,0\n");
  EXPECT_INPUT_ERROR(import(), "Snapshots.csv:2: 9 fields, expected 10");
  copy.replace("Snapshots.csv", header + "1,1,5,99,4,0,1,0,0,0\n");
  EXPECT_INPUT_ERROR(import(), "Snapshots.csv:2: subject 99 is not in Landmark_Groundtruth.dat");
  copy.replace("Snapshots.csv", header + "2,1,5,6,4,0,1,0,0,0\n1,1,5,6,4,0,1,0,0,0\n");
  EXPECT_INPUT_ERROR(import(), "Snapshots.csv:3: snapshot 1, expected ascending");
  copy.replace("Snapshots.csv", header + "1,1,5,6,x,0,1,0,0,0\n");
  EXPECT_INPUT_ERROR(import(), "Snapshots.csv:2: 'x' is not a number, expected range_m");
  copy.replace("Snapshots.csv", "snapshot,robot\n");
  EXPECT_INPUT_ERROR(import(), "Snapshots.csv:1: no column 'subject'");
  copy.remove("Snapshots.csv");
  EXPECT_INPUT_ERROR(import(), "Snapshots.csv: no such file");
}

TEST(MrclamRecordings, SnapshotsHaveTheKnownCounts)
{
  const auto root = testing::recordingsFolder("mrclam");
  if (!std::filesystem::exists(root)) GTEST_SKIP() << "no " << root << ", set LANDMARK_DATA_DIR";
  const std::pair<int, std::size_t> expected[] = {{1, 735}, {2, 2259}, {3, 2178}, {5, 2740}, {6, 542}};
  for (const auto& [set, count] : expected)
  {
    const Recording recording = importMrclamSnapshots(root / ("MRCLAM_Dataset" + std::to_string(set)));
    EXPECT_EQ(recording.records.size(), count) << set;
    EXPECT_EQ(recording.truth.size(), count) << set;
  }
}
}  // namespace mrpt_ext::test_mrclam_snapshots
