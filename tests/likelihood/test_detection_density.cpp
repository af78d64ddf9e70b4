#include "mrpt_ext/likelihood/detection_density.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_detection_density
{
TEST(DetectionDensity, FalseDetectionsFillFieldOfViewRangeAndCategories)
{
  const SensorModel plain, declared{.field_of_view = 2, .max_range = 8.0, .has_field_of_view = true};
  const Detection bearing{.bearing = 0.0}, range{.range = 1.0}, both{.bearing = 0.0, .range = 1.0};
  EXPECT_EQ(measurementVolume(bearing, plain, 30), kTwoPi);
  EXPECT_EQ(measurementVolume(range, plain, 30), 30);
  EXPECT_EQ(measurementVolume(bearing, declared, 30), 2);
  EXPECT_EQ(measurementVolume(both, declared, 30), 16);
  EXPECT_EQ(measurementVolume(both, declared, 30, 3), 48);
}

TEST(DetectionDensity, ClutterIsNeitherImpossibleNorCertain)
{
  EXPECT_EQ(boundedClutter(0), kMinClutterProbability);
  EXPECT_EQ(boundedClutter(0.2), 0.2);
  EXPECT_EQ(boundedClutter(1), kMaxClutterProbability);
}

TEST(DetectionDensity, AssumedRangeIsOneAndAHalfDiagonals)
{
  EXPECT_EQ(defaultMaxRange(Vector2d(1, 1), Vector2d(4, 5)), 7.5);
  EXPECT_EQ(defaultMaxRange(Vector2d(0, 0), Vector2d(0, 0)), 1);
}

TEST(DetectionDensity, LogDensityIsThatOfIndependentNormalDistributions)
{
  const Detection z{.bearing = 0.1, .range = 3.0, .std_bearing = 0.3, .std_range = 0.4};
  const LandmarkPrediction h{.bearing = -0.1, .range = 2.5, .bearing_variance = 0.16, .range_variance = 0.09};
  const double expected = -0.5 * (0.04 / 0.25 + std::log(kTwoPi * 0.25) + 0.25 / 0.25 + std::log(kTwoPi * 0.25));
  EXPECT_NEAR(logDensity(z, h), expected, 1e-12);
}
}  // namespace mrpt_ext::test_detection_density
