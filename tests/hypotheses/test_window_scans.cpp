#include "mrpt_ext/hypotheses/window_scans.h"

#include <gtest/gtest.h>

#include "mrpt_ext/hypotheses/scans.h"
#include "window_of_readings.h"

namespace mrpt_ext::test_window_scans
{
namespace
{
WorkBudget unlimited;
const LandmarkTable kMap = fiveLandmarks();
const LandmarkIndex kIndex(kMap);
const Pose2 kRobot{2.5, 2, -1.6};
const ExactSensor kAnonymous{.identified = false, .category = true, .T_robot_sensor = {0.2, -0.1, 0.9}};
const std::vector<std::size_t> kAll{0, 1, 2, 3, 4};
}  // namespace

TEST(WindowScans, BearingsOfAWindowBecomePointsWithRanges)
{
  const auto readings = windowOfReadings(kRobot, {0.3, 0, 0.1}, 6, kMap, kAll, kAnonymous);
  const std::vector<Scan> scans = windowScans(readings, kMap, kIndex, unlimited);
  ASSERT_FALSE(scans.empty());
  ASSERT_GE(scans.front().detections.size(), kAll.size() - 1) << "all but one nearly in line with the motion";
  for (const AnonymousDetection& d : scans.front().detections)
  {
    ASSERT_TRUE(d.bearing && d.range);
    const Vector2d at = transform(kRobot, *d.range * Vector2d(std::cos(*d.bearing), std::sin(*d.bearing)));
    double nearest = 1e9;
    for (std::size_t j = 0; j < kMap.size(); ++j)
      if (kIndex.mayShow(d.category, j)) nearest = std::min(nearest, (kIndex.position(j) - at).norm());
    EXPECT_LT(nearest, 1e-3);
  }
}

TEST(WindowScans, ReadingsOfOneFrameStayAsTheyAre)
{
  const std::vector<Reading> readings{seenFrom(kRobot, kMap, kAll, kAnonymous),
                                      seenFrom(kRobot, kMap, {1}, kAnonymous)};
  const auto merged = windowScans(readings, kMap, kIndex, unlimited), plain = scansOf(readings, kMap, kIndex);
  ASSERT_EQ(merged.size(), plain.size());
  for (std::size_t k = 0; k < plain.size(); ++k) EXPECT_EQ(merged[k].detections.size(), plain[k].detections.size());
}

TEST(WindowScans, OdometryNoiseIsKeptApartFromSensorNoise)
{
  const auto readings = windowOfReadings(kRobot, {0.3, 0, 0.1}, 4, kMap, kAll, kAnonymous);
  const std::vector<PastScan> scans = pastScans(readings, kMap, kIndex);
  ASSERT_EQ(scans.size(), readings.size());
  for (std::size_t k = 0; k < scans.size(); ++k)
  {
    EXPECT_EQ(scans[k].odometry_covariance, readings[k].odometry_covariance);
    EXPECT_NEAR(scans[k].scan.detections[0].std_bearing, kAnonymous.std_bearing, 1e-9);
  }
}
}  // namespace mrpt_ext::test_window_scans
