#include "mrpt_ext/importers/scan_table.h"

#include <gtest/gtest.h>

#include "sample_data.h"

namespace mrpt_ext::test_scan_table
{
namespace
{
const std::map<std::string, SensorPose> kSensors{{"laser", {{1, 0.5, 0.1}, 0.3, BeamSpan{degToRad(-90), degToRad(90)}}},
                                                 {"sonar", {{0, 0, 0}, 0, {}}}};

std::vector<RangeScan> read(const std::string& text)
{
  const testing::ScratchFolder folder;
  return readScanTable(folder.write("scans.csv", text), kSensors);
}
}  // namespace

TEST(ScanTable, ReadsRangesAndIntensities)
{
  const auto scans = read("t,r0,r1,r2,i0,i1,i2\n0.5,1,2,0,0,100,0\n0.7,1,2,3,0,0,0\n");
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans[0].time, 0.5);
  EXPECT_EQ(scans[0].sensor, "laser");
  EXPECT_EQ(scans[0].T_robot_sensor.x, 1);
  EXPECT_EQ(scans[0].ranges, (std::vector<float>{1, 2, 0}));
  EXPECT_EQ(scans[0].intensities, (std::vector<float>{0, 100, 0}));
  EXPECT_DOUBLE_EQ(scans[0].first_bearing, degToRad(-90));
  EXPECT_DOUBLE_EQ(scans[0].bearing_step, degToRad(90));
}

TEST(ScanTable, MistakesAreALine)
{
  EXPECT_INPUT_ERROR(read("t,r0,r1,i0\n0,1,1,1\n"), "2 columns r0, r1, ... and 1 columns i0");
  EXPECT_INPUT_ERROR(read("t,r0,r1,i0,i1,x\n0,1,1,1,1,1\n"), "1 other columns");
  EXPECT_INPUT_ERROR(read("t,r0,r1,i0,i1\n0,1,-1,1,1\n"), "scans.csv:2: a range of -1 m");
  EXPECT_INPUT_ERROR(read("t,r0,r1,i0,i1\n1,1,1,1,1\n0,1,1,1,1\n"), "scans.csv:3: a time before");
  EXPECT_INPUT_ERROR(read("t,sensor,r0,r1,i0,i1\n0,sonar,1,1,1,1\n"), "a scan of sensor 'sonar', expected its row");
  EXPECT_INPUT_ERROR(read("t,sensor,r0,r1,i0,i1\n0,rear,1,1,1,1\n"), "a scan of sensor 'rear'");
}
}  // namespace mrpt_ext::test_scan_table
