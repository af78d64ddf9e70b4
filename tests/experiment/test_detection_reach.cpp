#include "mrpt_ext/experiment/detection_reach.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_detection_reach
{
namespace
{
constexpr double kMapDiagonal = 5;

Reading readingOf(const Detection& detection, std::optional<double> max_range = {})
{
  Reading reading;
  reading.model.max_range = max_range;
  reading.detections = {detection};
  return reading;
}

Reading rangeOf(double range) { return readingOf({.id = 1, .range = range, .std_range = 0.1}); }
Reading bearing(std::optional<double> max_range = {})
{
  return readingOf({.id = 1, .bearing = 0.3, .std_bearing = 0.01}, max_range);
}
}  // namespace

TEST(DetectionReach, IsNearlyTheLongestRangeAndNoFalseOne)
{
  DetectionReach reach;
  for (int k = 1; k <= 1000; ++k) reach.add(rangeOf(0.01 * k));
  reach.add(rangeOf(655.35));
  ASSERT_TRUE(reach.metres(kMapDiagonal));
  EXPECT_GE(*reach.metres(kMapDiagonal), 9.9);
  EXPECT_LT(*reach.metres(kMapDiagonal), 1.1 * 9.9);
}

TEST(DetectionReach, OfBearingsIsTheLimitOfTheirSensorOrAMultipleOfTheMap)
{
  DetectionReach reach;
  reach.add(bearing(8));
  EXPECT_EQ(reach.metres(kMapDiagonal), 8);
  reach.add(bearing());
  EXPECT_EQ(reach.metres(kMapDiagonal), 15);
}

TEST(DetectionReach, IsUnknownWithoutDetectionsOrWithAnonymousOnes)
{
  DetectionReach reach;
  EXPECT_FALSE(reach.metres(kMapDiagonal));
  reach.add(rangeOf(7));
  EXPECT_TRUE(reach.metres(kMapDiagonal));
  reach.add(readingOf({.bearing = 0.3, .range = 5.0, .std_bearing = 0.01, .std_range = 0.1}));
  EXPECT_FALSE(reach.metres(kMapDiagonal));
}
}  // namespace mrpt_ext::test_detection_reach
