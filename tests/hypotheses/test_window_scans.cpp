#include "mrpt_ext/hypotheses/window_scans.h"

#include <gtest/gtest.h>

#include "mrpt_ext/hypotheses/scans.h"
#include "window_of_readings.h"

namespace mrpt_ext
{
namespace
{
const LandmarkTable kMap = fiveLandmarks();
const LandmarkIndex kIndex(kMap);
const Pose2 kRobot{2.5, 2, -1.6};
const ExactSensor kNameless{.named = false, .category = true, .T_robot_sensor = {0.2, -0.1, 0.9}};
const std::vector<std::size_t> kAll{0, 1, 2, 3, 4};
}  // namespace

TEST(JoinedPlaces, BearingsAlongAWayBecomePointsWithDistances)
{
  const auto readings = seenAlong(kRobot, {0.3, 0, 0.1}, 6, kMap, kAll, kNameless);
  const std::vector<Scan> places = windowScans(readings, kMap, kIndex);
  ASSERT_FALSE(places.empty());
  ASSERT_GE(places.front().detections.size(), kAll.size() - 1) << "all but one nearly in line with the way";
  for (const AnonymousDetection& d : places.front().detections)
  {
    ASSERT_TRUE(d.bearing && d.range);
    const Vector2d at = transform(kRobot, *d.range * Vector2d(std::cos(*d.bearing), std::sin(*d.bearing)));
    double nearest = 1e9;
    for (std::size_t j = 0; j < kMap.size(); ++j)
      if (kIndex.mayShow(d.kind, j)) nearest = std::min(nearest, (kIndex.position(j) - at).norm());
    EXPECT_LT(nearest, 1e-3);
  }
}

TEST(JoinedPlaces, ReadingsOfOneMomentStayAsTheyAre)
{
  const std::vector<Reading> readings{seenFrom(kRobot, kMap, kAll, kNameless), seenFrom(kRobot, kMap, {1}, kNameless)};
  const auto joined = windowScans(readings, kMap, kIndex), plain = scansOf(readings, kMap, kIndex);
  ASSERT_EQ(joined.size(), plain.size());
  for (std::size_t k = 0; k < plain.size(); ++k) EXPECT_EQ(joined[k].detections.size(), plain[k].detections.size());
}

TEST(JoinedPlaces, TheWayIsKeptApartFromTheSensor)
{
  const auto readings = seenAlong(kRobot, {0.3, 0, 0.1}, 4, kMap, kAll, kNameless);
  const std::vector<PastScan> places = carriedPlaces(readings, kMap, kIndex);
  ASSERT_EQ(places.size(), readings.size());
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    EXPECT_EQ(places[k].odometry_covariance, readings[k].odometry_covariance);
    EXPECT_NEAR(places[k].scan.detections[0].std_bearing, kNameless.std_bearing, 1e-9);
  }
}
}  // namespace mrpt_ext
