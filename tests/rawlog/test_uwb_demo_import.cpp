#include "mrpt_ext/rawlog/uwb_demo_import.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../importers/sample_data.h"
#include "mrpt_ext/files/landmark_csv.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/importers/uwb_demo_map.h"
#include "mrpt_ext/maps/register_all_classes.h"
#include "mrpt_ext/rawlog/rawlog_sink.h"

namespace mrpt_ext::test_uwb_demo_import
{
namespace
{
const std::filesystem::path kDemo = "/usr/share/mrpt/datasets/uwb_ro-localization_demo.rawlog";

class UwbDemoImport : public ::testing::Test
{
 protected:
  UwbDemoImport() { registerAllClasses(); }
};

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// Measured range minus the distance between the true antenna and the beacon.
std::vector<double> rangeErrors(const Recording& recording, int beacon)
{
  std::vector<double> errors;
  for (const Reading& reading : testing::recordsOf<Reading>(recording))
    for (const Detection& detection : reading.detections)
    {
      const auto truth = interpolate(recording.truth, reading.time, 3);
      if (detection.id != beacon || !truth) continue;
      const Pose2 antenna = compose(truth->pose, reading.T_robot_sensor);
      const Vector3d position(antenna.x, antenna.y, reading.sensor_height);
      errors.push_back(*detection.range -
                       (recording.map[recording.map.indexOf(beacon).value()].position - position).norm());
    }
  return errors;
}
}  // namespace

TEST_F(UwbDemoImport, MapFileOfTheConfigurationIsTheSameMap)
{
  const auto path = std::filesystem::path(MRPT_EXT_SOURCE_DIR) / "ini/landmark-localization/mrpt-uwb-demo_map.csv";
  const LandmarkTable map = readLandmarkCsv(path);
  ASSERT_EQ(map.size(), uwbDemoMap().size());
  for (std::size_t i = 0; i < map.size(); ++i)
  {
    EXPECT_EQ(map[i].id, uwbDemoMap()[i].id);
    EXPECT_EQ(map[i].position, uwbDemoMap()[i].position);
  }
}

// Two of the beacons are good ones: their errors, known from an independent reading of the log, show that truth, map,
// antenna and times belong together.
TEST_F(UwbDemoImport, RangesFitTheTruth)
{
  if (!std::filesystem::exists(kDemo)) GTEST_SKIP() << "no " << kDemo << ", install mrpt-common";
  const Recording recording = importUwbDemo(kDemo, {}, kUwbDemoStart, uwbDemoMap());
  EXPECT_EQ(recording.truth.size(), 342u);
  EXPECT_EQ(recording.truth.front().pose.vector(), Vector3d(2, 4, 0));
  EXPECT_FALSE(testing::hasNote(recording, "warning"));
  EXPECT_TRUE(testing::hasNote(recording, "6 unusable"));
  const std::pair<int, double> expected_means[] = {{2, -0.054}, {3, -0.025}};
  for (const auto& [beacon, mean] : expected_means)
  {
    const auto errors = rangeErrors(recording, beacon);
    EXPECT_GT(errors.size(), 330u);
    EXPECT_NEAR(median(errors), mean, 0.03) << beacon;
    EXPECT_LT(std::count_if(errors.begin(), errors.end(), [](double e) { return std::abs(e) > 0.5; }), 12) << beacon;
  }
}

TEST_F(UwbDemoImport, OriginMovesTheTruth)
{
  if (!std::filesystem::exists(kDemo)) GTEST_SKIP() << "no " << kDemo << ", install mrpt-common";
  const Recording recording = importUwbDemo(kDemo, {}, {1, 1, kPi / 2}, uwbDemoMap());
  EXPECT_NEAR(recording.truth.front().pose.phi, kPi / 2, 1e-12);
  const Recording usual = importUwbDemo(kDemo, {}, kUwbDemoStart, uwbDemoMap());
  const Pose2 before = between(kUwbDemoStart, usual.truth[100].pose),
              after = between({1, 1, kPi / 2}, recording.truth[100].pose);
  EXPECT_NEAR((before.position() - after.position()).norm(), 0, 1e-9);
}

TEST_F(UwbDemoImport, WrongInputIsNamed)
{
  const testing::ScratchFolder folder;
  Recording odometry_only;
  odometry_only.records = {OdometryRecord{1, {}}};
  writeRawlog(folder.path() / "a.rawlog", odometry_only);
  EXPECT_INPUT_ERROR((void)importUwbDemo(folder.path() / "a.rawlog", {}, kUwbDemoStart, uwbDemoMap()),
                     "a.rawlog: no action/sensory-frame pairs");
  if (!std::filesystem::exists(kDemo)) GTEST_SKIP() << "no " << kDemo << ", install mrpt-common";
  const auto truth = folder.write("gt.txt", "0 0 0 0\n343 1 1 0\n");
  EXPECT_INPUT_ERROR((void)importUwbDemo(kDemo, truth, kUwbDemoStart, uwbDemoMap()), "gt.txt: truth up to step 343");
}
}  // namespace mrpt_ext::test_uwb_demo_import
