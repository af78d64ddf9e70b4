#include "mrpt_ext/importers/labyrinth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "mrpt_ext/geometry/input_error.h"
#include "sample_data.h"

namespace mrpt_ext::test_labyrinth
{
using testing::DamagedCopy;
using testing::hasNote;
using testing::recordsOf;

TEST(Labyrinth, WheelSpeedsAreIntegratedAsArcs)
{
  const Recording recording = importLabyrinth(testing::sampleFolder("labyrinth"));
  const auto odometry = recordsOf<OdometryRecord>(recording);
  ASSERT_EQ(odometry.size(), 3u);
  EXPECT_NEAR(odometry[1].pose.x, 0.1, 1e-12);
  // The left wheel stands, the right one drives a quarter of a circle around it: 0.1 m is half of the axle.
  EXPECT_NEAR(odometry[2].pose.x, 0.1 + 0.1, 1e-9);
  EXPECT_NEAR(odometry[2].pose.y, 0.1, 1e-9);
  EXPECT_NEAR(odometry[2].pose.phi, kPi / 2, 1e-9);
  EXPECT_TRUE(hasNote(recording, "3 rows of wheel speeds"));
}

TEST(Labyrinth, RangesHaveTheirStdAndTheModulesMakeTheMap)
{
  const Recording recording = importLabyrinth(testing::sampleFolder("labyrinth"));
  const auto readings = recordsOf<Reading>(recording);
  ASSERT_EQ(readings.size(), 3u);
  EXPECT_EQ(readings[1].time, 0.6);
  EXPECT_EQ(readings[1].detections.at(0).id, 107);
  EXPECT_EQ(readings[1].detections.at(0).range, 1.5);
  EXPECT_NEAR(readings[1].detections.at(0).std_range, 0.2, 1e-12);
  EXPECT_TRUE(hasNote(recording, "4 rows of ranges"));
  EXPECT_TRUE(hasNote(recording, "1 ranges of 0 dropped"));
  ASSERT_EQ(recording.map.size(), 3u);
  EXPECT_EQ(recording.map[recording.map.indexOf(108).value()].position, Vector3d(2.4, 2.4, 0));
  ASSERT_EQ(recording.truth.size(), 2u);
  EXPECT_FALSE(recording.truth[0].heading_known);
}

TEST(Labyrinth, DamagedFilesAreNamedWithTheirLine)
{
  const DamagedCopy copy("labyrinth");
  const auto import = [&] { (void)importLabyrinth(copy.path()); };
  const auto damaged = [&](const std::string& row)
  { copy.replace("Room_Input.txt", "range2 0.1 2.5 0.01 0 0 105 0\n" + row + "\n"); };
  damaged("range2 0.6 1.5 0.01 2.4 0 107");
  EXPECT_INPUT_ERROR(import(), "Room_Input.txt:2: 7 fields, expected 8");
  damaged("range3 0.6 1.5 0.01 2.4 0 107 0");
  EXPECT_INPUT_ERROR(import(), "Room_Input.txt:2: unknown type of row 'range3', expected range2 or odom2diff");
  damaged("range2 0.05 1.5 0.01 2.4 0 107 0");
  EXPECT_INPUT_ERROR(import(), "Room_Input.txt:2: time 0.05 is before the row above");
  damaged("range2 0.6 1500 0.01 2.4 0 107 0");
  EXPECT_INPUT_ERROR(import(), "Room_Input.txt:2: range 1500, expected metres within 0 ... 100");
  damaged("range2 0.6 1.5 -0.01 2.4 0 107 0");
  EXPECT_INPUT_ERROR(import(), "Room_Input.txt:2: variance -0.01, expected > 0");
  damaged("range2 0.6 1.5 0.01 2.4 0 105 0");
  EXPECT_INPUT_ERROR(import(), "Room_Input.txt:2: module 105 has another position than before");
  damaged("odom2diff 0.6 0.1 0.1 0 0 0.1 0.1 0.1");
  EXPECT_INPUT_ERROR(import(), "Room_Input.txt:2: half_axle 0, expected > 0 m");
  copy.remove("Room_Input.txt");
  EXPECT_INPUT_ERROR(import(), "no file <run>_Input.txt in this folder");
}

// Dead reckoning as documented ends where the truth does: 9.2 m of distance, no more than 0.2 m off after alignment.
TEST(LabyrinthRecordings, DeadReckoningFitsTheTruth)
{
  const auto folder = testing::recordingsFolder("labyrinth_uwb");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder << ", set LANDMARK_DATA_DIR";
  const Recording recording = importLabyrinth(folder);
  const auto odometry = recordsOf<OdometryRecord>(recording);
  ASSERT_EQ(odometry.size(), recording.truth.size());
  ASSERT_EQ(recordsOf<Reading>(recording).size(), 233u);
  // The best rotation between both paths, by complex correlation about the means.
  Vector2d mean_odometry(0, 0), mean_truth(0, 0);
  for (std::size_t i = 0; i < odometry.size(); ++i)
  {
    mean_odometry += odometry[i].pose.position() / static_cast<double>(odometry.size());
    mean_truth += recording.truth[i].pose.position() / static_cast<double>(odometry.size());
  }
  double along = 0, across = 0;
  for (std::size_t i = 0; i < odometry.size(); ++i)
  {
    const Vector2d a = odometry[i].pose.position() - mean_odometry, b = recording.truth[i].pose.position() - mean_truth;
    along += a.dot(b);
    across += a.x() * b.y() - a.y() * b.x();
  }
  const Eigen::Rotation2D<double> rotation(std::atan2(across, along));
  for (std::size_t i = 0; i < odometry.size(); ++i)
  {
    const Vector2d laid_over = mean_truth + rotation * (odometry[i].pose.position() - mean_odometry);
    EXPECT_LT((laid_over - recording.truth[i].pose.position()).norm(), 0.2) << odometry[i].time;
  }
}
}  // namespace mrpt_ext::test_labyrinth
