#include "mrpt_ext/importers/mrclam.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/files/tum.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/mrclam_files.h"
#include "sample_data.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_mrclam
{
using testing::DamagedCopy;
using testing::hasNote;
using testing::recordsOf;

TEST(Mrclam, BarcodesBecomeLandmarksAndNothingIsLostSilently)
{
  const Recording recording = importMrclam(testing::sampleFolder("mrclam"), 1);
  const auto readings = recordsOf<Reading>(recording);
  ASSERT_EQ(readings.size(), 2u);
  EXPECT_EQ(readings[0].time, 1000.5);
  EXPECT_EQ(readings[0].sensor, "camera.1");
  ASSERT_EQ(readings[0].detections.size(), 2u);
  EXPECT_EQ(readings[0].detections[0].id, 6);
  EXPECT_EQ(readings[0].detections[1].id, 7);
  EXPECT_EQ(readings[0].detections[1].range, 4.427);
  EXPECT_EQ(readings[0].detections[1].bearing, 0.469);
  EXPECT_EQ(readings[1].detections.at(0).id, 8);
  EXPECT_TRUE(hasNote(recording, "6 rows of measurements"));
  EXPECT_TRUE(hasNote(recording, "1 readings of other robots dropped"));
  EXPECT_TRUE(hasNote(recording, "1 readings of unknown barcodes dropped"));
  EXPECT_TRUE(hasNote(recording, "1 readings of landmarks without a position dropped"));
  EXPECT_EQ(recording.map.size(), 3u);
  EXPECT_EQ(recording.map[0].stddev, Vector2d(0.0001, 0.0002));
}

TEST(Mrclam, OdometryIsIntegratedAndOrderedWithTheReadings)
{
  const Recording recording = importMrclam(testing::sampleFolder("mrclam"), 1);
  const auto odometry = recordsOf<OdometryRecord>(recording);
  ASSERT_EQ(odometry.size(), 4u);
  EXPECT_NEAR(odometry[1].pose.x, 0.1, 1e-12);
  EXPECT_NEAR(odometry[2].pose.x, 0.1 + 0.2 / kPi, 1e-12);
  EXPECT_NEAR(odometry[2].pose.y, 0.2 / kPi, 1e-12);
  EXPECT_EQ(odometry[3].pose.vector(), odometry[2].pose.vector());
  EXPECT_TRUE(hasNote(recording, "5 rows of commanded velocities"));
  EXPECT_TRUE(hasNote(recording, "1 of them share the stamp"));
  for (std::size_t i = 1; i < recording.records.size(); ++i)
    EXPECT_LE(timeOf(recording.records[i - 1]), timeOf(recording.records[i]));
}

TEST(Mrclam, TruthIsDenseIfPresentElseSparse)
{
  const Recording dense = importMrclam(testing::sampleFolder("mrclam"), 1);
  EXPECT_EQ(dense.truth.size(), 3u);
  EXPECT_TRUE(hasNote(dense, "truth: motion capture"));

  const Recording sparse = importMrclam(testing::sampleFolder("mrclam"), 2);
  EXPECT_TRUE(hasNote(sparse, "truth: sparse"));
  EXPECT_TRUE(hasNote(sparse, "no odometry file"));
  ASSERT_EQ(sparse.truth.size(), 3u);  // one of the four intervals has the middle of another
  EXPECT_EQ(sparse.truth[0].time, 1000.0);
  EXPECT_EQ(sparse.truth[1].time, 1000.5);
  EXPECT_EQ(sparse.truth[2].time, 1002.0);
  EXPECT_NEAR(sparse.truth[2].pose.phi, 7.0 - kTwoPi, 1e-12);
}

// Intervals of the same middle, as doubles 2.4e-7 s apart.
TEST(Mrclam, SparseTruthCanBeReadBackFromItsFile)
{
  const testing::ScratchFolder folder;
  folder.write("GroundtruthSparse.csv",
               "robot,t_begin,t_end,x_m,y_m,theta_rad\n1,1248295785.131,1248295785.818,0,0,0\n"
               "1,1248295785.360,1248295785.589,0,0,0\n1,1248295786,1248295786,0,0,0\n");
  const auto truth = readMrclamSparseTruth(folder.path(), 1);
  ASSERT_TRUE(truth);
  writeTum(folder.path() / "truth.tum", *truth);
  EXPECT_EQ(readTum(folder.path() / "truth.tum").size(), 2U);
}

TEST(Mrclam, DamagedFilesAreNamedWithTheirLine)
{
  const DamagedCopy copy("mrclam");
  const auto import = [&] { (void)importMrclam(copy.path(), 1); };
  copy.replace("Robot1_Measurement.dat", "1000.5 72 3.95 0\n1000.6 72 3.95\n");
  EXPECT_INPUT_ERROR(import(), "Robot1_Measurement.dat:2: 3 fields, expected 4 (time,barcode,range,bearing)");
  copy.replace("Robot1_Measurement.dat", "1000.5 72 3.9x 0\n");
  EXPECT_INPUT_ERROR(import(), "Robot1_Measurement.dat:1: '3.9x' is not a number, expected range");
  copy.replace("Robot1_Measurement.dat", "1000.5 72 -3.9 0\n");
  EXPECT_INPUT_ERROR(import(), "Robot1_Measurement.dat:1: range -3.9 m, expected > 0");
  copy.replace("Robot1_Measurement.dat", "1000.5 72 3.9 45\n");
  EXPECT_INPUT_ERROR(import(), "Robot1_Measurement.dat:1: bearing 45, expected radians");
  copy.replace("Robot1_Odometry.dat", "1000 0.1 nan\n");
  EXPECT_INPUT_ERROR(import(), "Robot1_Odometry.dat:1: 'nan' is not a number, expected angular_velocity");
  copy.replace("Landmark_Groundtruth.dat", "6 0 0 0 0\n6 1 1 0 0\n");
  EXPECT_INPUT_ERROR(import(), "Landmark_Groundtruth.dat:2: subject 6 is negative or occurs twice");
}

TEST(Mrclam, MissingFilesAndRobotsAreNamed)
{
  const DamagedCopy copy("mrclam");
  EXPECT_INPUT_ERROR((void)importMrclam(copy.path(), 4), "no robot 4, expected one of 1, 2");
  EXPECT_INPUT_ERROR((void)importMrclam(copy.path() / "none", 1), "none: no such folder");
  copy.remove("Barcodes.dat");
  EXPECT_INPUT_ERROR((void)importMrclam(copy.path(), 1), "Barcodes.dat: no such file");
  copy.replace("Barcodes.dat", "1 5\n2 5\n");
  EXPECT_INPUT_ERROR((void)importMrclam(copy.path(), 1), "Barcodes.dat:2: barcode 5 occurs twice");
}

namespace
{
constexpr double kTruthGap = 0.2;  // [s]; longer gaps in the motion capture were left out when the noise was measured

/// Residuals of the landmark readings of one robot against the motion capture, by its published split.
struct Residuals
{
  std::size_t readings = 0, compared = 0, outliers = 0;
  double range_sum = 0, range_squares = 0, bearing_sum = 0, bearing_squares = 0;

  void add(const Recording& recording)
  {
    for (const Reading& reading : recordsOf<Reading>(recording))
      for (const Detection& detection : reading.detections)
      {
        ++readings;
        if (const auto truth = interpolate(recording.truth, reading.time, kTruthGap))
          compare(detection, truth->pose, recording.map);
      }
  }

  void compare(const Detection& detection, const Pose2& pose, const LandmarkTable& map)
  {
    const Vector2d seen = transform(inverse(pose), map[map.indexOf(detection.id).value()].position.head<2>());
    const double range = *detection.range - seen.norm();
    const double bearing = wrap(*detection.bearing - std::atan2(seen.y(), seen.x()));
    ++compared;
    if (std::abs(range) >= 0.5 || std::abs(bearing) >= 0.25)
    {
      ++outliers;
      return;
    }
    range_sum += range;
    range_squares += square(range);
    bearing_sum += bearing;
    bearing_squares += square(bearing);
  }

  [[nodiscard]] double inliers() const { return static_cast<double>(compared - outliers); }
  [[nodiscard]] double rangeMean() const { return range_sum / inliers(); }
  [[nodiscard]] double rangeStd() const { return std::sqrt(range_squares / inliers() - square(rangeMean())); }
  [[nodiscard]] double bearingMeanDeg() const { return radToDeg(bearing_sum / inliers()); }
  [[nodiscard]] double bearingStdDeg() const
  {
    return std::sqrt(square(radToDeg(1)) * bearing_squares / inliers() - square(bearingMeanDeg()));
  }
};
}  // namespace

// The figures were measured independently on the same files, before this importer existed.
TEST(Mrclam, RowsOutOfOrderAreSortedWithAWarning)
{
  const DamagedCopy copy("mrclam");
  copy.replace("Robot1_Measurement.dat", "1000.5 72 2 0\n1000.4 72 1 0\n");
  const Recording recording = importMrclam(copy.path(), 1);
  EXPECT_TRUE(hasNote(recording, "Robot1_Measurement.dat:2: time goes back to 1000.4, rows were sorted"));
  const auto readings = recordsOf<Reading>(recording);
  ASSERT_EQ(readings.size(), 2U);
  EXPECT_EQ(readings[0].time, 1000.4);
  copy.replace("Robot1_Groundtruth.dat", "1001 0 0 0\n1000 1 1 0\n1001 2 2 0\n");
  EXPECT_INPUT_ERROR((void)importMrclam(copy.path(), 1), "Robot1_Groundtruth.dat: time 1001.000 occurs twice");
}

TEST(MrclamRecordings, SetSixHasTheKnownCountsAndNoise)
{
  const auto folder = testing::recordingsFolder("mrclam") / "MRCLAM_Dataset6";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder << ", set LANDMARK_DATA_DIR";
  Residuals residuals;
  for (const int robot : mrclamRobots(folder))
  {
    const Recording recording = importMrclam(folder, robot);
    EXPECT_FALSE(hasNote(recording, "warning")) << "robot " << robot;
    residuals.add(recording);
  }
  EXPECT_EQ(residuals.readings, 15383u);  // of 19377 rows, 3988 of other robots, 6 of unknown barcodes
  EXPECT_EQ(residuals.compared, 15359u);
  EXPECT_NEAR(static_cast<double>(residuals.outliers) / static_cast<double>(residuals.compared), 0.022, 0.001);
  EXPECT_NEAR(residuals.rangeMean(), -0.024, 0.002);
  EXPECT_NEAR(residuals.rangeStd(), 0.155, 0.002);
  EXPECT_NEAR(residuals.bearingMeanDeg(), -0.11, 0.02);
  EXPECT_NEAR(residuals.bearingStdDeg(), 0.71, 0.02);
}

TEST(MrclamRecordings, EverySetOfEveryRobotIsReadWhole)
{
  const auto root = testing::recordingsFolder("mrclam");
  if (!std::filesystem::exists(root)) GTEST_SKIP() << "no " << root << ", set LANDMARK_DATA_DIR";
  for (const int set : {1, 2, 3, 5})
  {
    const auto folder = root / ("MRCLAM_Dataset" + std::to_string(set));
    const auto robots = mrclamRobots(folder);
    ASSERT_EQ(robots.size(), 5u) << set;
    const int robot = robots[static_cast<std::size_t>(set + 1) % 5];
    const Recording recording = importMrclam(folder, robot);
    EXPECT_GT(recordsOf<Reading>(recording).size(), 900u) << set;
    EXPECT_GT(recording.truth.size(), 50u) << set;
    EXPECT_FALSE(hasNote(recording, "warning")) << set;
    EXPECT_EQ(hasNote(recording, "no odometry file"), set == 5) << set;
  }
}
}  // namespace mrpt_ext::test_mrclam
