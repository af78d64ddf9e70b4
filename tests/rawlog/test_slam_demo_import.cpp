#include "mrpt_ext/rawlog/slam_demo_import.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "../importers/sample_data.h"
#include "mrpt_ext/geometry/input_error.h"
#include "rawlog_samples.h"

namespace mrpt_ext::test_slam_demo_import
{
namespace
{
const std::filesystem::path kDemos = "/usr/share/mrpt/datasets";

class SlamDemoImport : public RawlogTest
{
};
}  // namespace

// Ranges and bearings are those of the true poses to the true landmarks.
TEST_F(SlamDemoImport, DetectionsFitMapAndTruth)
{
  if (!std::filesystem::exists(kDemos / "kf-slam_demo.rawlog")) GTEST_SKIP() << "install mrpt-common";
  const Recording recording = importKfSlamDemo({kDemos / "kf-slam_demo.rawlog"});
  EXPECT_EQ(recording.map.size(), 70U);
  EXPECT_EQ(recording.truth.size(), 250U);
  std::vector<double> errors;
  for (const Reading& reading : testing::recordsOf<Reading>(recording))
  {
    const auto truth = interpolate(recording.truth, reading.time, 0.1);
    ASSERT_TRUE(truth.has_value());
    for (const Detection& detection : reading.detections)
    {
      const Vector3d landmark = recording.map[recording.map.indexOf(detection.id).value()].position;
      errors.push_back(std::abs((landmark.head<2>() - truth->pose.position()).norm() - *detection.range));
    }
  }
  EXPECT_EQ(errors.size(), 3607U);
  std::nth_element(errors.begin(), errors.begin() + 1800, errors.end());
  EXPECT_LT(errors[1800], 0.01);
}

TEST_F(SlamDemoImport, BeaconsOfTheRangeOnlyDemo)
{
  if (!std::filesystem::exists(kDemos / "RO-SLAM_demo.rawlog")) GTEST_SKIP() << "install mrpt-common";
  const Recording recording = importRoSlamDemo({kDemos / "RO-SLAM_demo.rawlog"});
  // The package makes the demo anew for each version: 15 beacons in 2.5.8, 14 in 2.14.7.
  std::ifstream beacons(kDemos / "RO-SLAM_demo_ground_truth.txt");
  std::size_t count = 0;
  for (std::string line; std::getline(beacons, line);) count += !line.empty() && line[0] != '%';
  EXPECT_GE(count, 5U);
  EXPECT_EQ(recording.map.size(), count);
  EXPECT_TRUE(recording.truth.empty());
  EXPECT_EQ(testing::recordsOf<Reading>(recording).size(), 100U);
}

TEST_F(SlamDemoImport, DemosInThreeDimensionsAreRefused)
{
  for (const char* name : {"kf-slam_6D_demo", "kf-slam_6D_demo_DA", "kf-slam_6D_demo_noncentered"})
  {
    const auto log = kDemos / (std::string(name) + ".rawlog");
    if (!std::filesystem::exists(log)) GTEST_SKIP() << "install mrpt-common";
    EXPECT_INPUT_ERROR((void)importKfSlamDemo({log}), "the robot moves in 3-D (CActionRobotMovement3D");
  }
}

TEST_F(SlamDemoImport, APathOfAnotherLogIsNamed)
{
  if (!std::filesystem::exists(kDemos / "kf-slam_demo.rawlog")) GTEST_SKIP() << "install mrpt-common";
  writeBytes(inFolder("path.txt"), "0 0 0 0 0 0\n");
  EXPECT_INPUT_ERROR((void)importKfSlamDemo({kDemos / "kf-slam_demo.rawlog", kDemos / "kf-slam_demo_ground_truth.txt",
                                             inFolder("path.txt")}),
                     "path.txt: 1 poses, but the log has 250 sensory frames");
}
}  // namespace mrpt_ext::test_slam_demo_import
