#include "mrpt_ext/experiment/detection_reach.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mrpt_ext::test_detection_reach
{
namespace
{
/// A wall of two landmarks along x, 4 m long and 3 m deep: the diagonal is 5 m.
const LandmarkTable kMap({{.id = 1, .position = {0, 0, 0}}, {.id = 2, .position = {4, 3, 0}}});

Frame frameOf(double time, const Detection& detection, std::optional<double> max_range = {})
{
  Reading reading;
  reading.model.max_range = max_range;
  reading.detections = {detection};
  return {.time = time, .readings = {reading}};
}

Detection rangeOf(int id, double range) { return {.id = id, .range = range, .std_range = 0.1}; }
const Detection kBearing{.id = 1, .bearing = 0.3, .std_bearing = 0.01};
}  // namespace

TEST(DetectionReach, IsHowFarBeyondTheMapTheRobotWas)
{
  DetectionReach reach;
  for (int k = 0; k < 6000; ++k)  // ten minutes at 10 Hz: away from the map along x and back
  {
    const Vector2d robot(16 - std::abs(k - 3000) / 300.0, 1.5);
    const int id = 1 + k % 2;
    const double range = (kMap[*kMap.indexOf(id)].position.head<2>() - robot).norm();
    reach.add(frameOf(1.7e9 + 0.1 * k, rangeOf(id, k % 20 == 0 ? 0.5 : range)), kMap);
  }
  EXPECT_GE(reach.metres(), 11.5);
  EXPECT_LT(reach.metres(), 1.1 * 12.2);
}

TEST(DetectionReach, IsNothingBetweenTheLandmarks)
{
  DetectionReach reach;
  for (int k = 0; k < 100; ++k) reach.add(frameOf(k, rangeOf(1 + k % 2, 2.5)), kMap);
  EXPECT_LT(reach.metres(), 0.01);  // the robot is in the middle: what one range allows the other excludes
}

TEST(DetectionReach, OfAFewSecondsIsThatOfThese)
{
  DetectionReach reach;
  reach.add(frameOf(5, rangeOf(1, 7)), kMap);
  EXPECT_EQ(reach.metres(), 7);
}

TEST(DetectionReach, OfBearingsIsTheLimitOfTheirSensorOrAMultipleOfTheMap)
{
  DetectionReach reach;
  reach.add(frameOf(0, kBearing, 8), kMap);
  EXPECT_EQ(reach.metres(), 8);
  reach.add(frameOf(1, kBearing), kMap);
  EXPECT_EQ(reach.metres(), 15);
}

TEST(DetectionReach, IsUnknownWithoutDetectionsOrWithAnonymousOnes)
{
  DetectionReach reach;
  EXPECT_EQ(reach.metres(), 0);
  reach.add(frameOf(0, rangeOf(77, 9)), kMap);  // of no landmark
  EXPECT_EQ(reach.metres(), 0);
  reach.add(frameOf(1, rangeOf(1, 9)), kMap);
  EXPECT_EQ(reach.metres(), 9);
  reach.add(frameOf(2, {.bearing = 0.3, .range = 5.0, .std_bearing = 0.01, .std_range = 0.1}), kMap);
  EXPECT_EQ(reach.metres(), 0);
}
}  // namespace mrpt_ext::test_detection_reach
