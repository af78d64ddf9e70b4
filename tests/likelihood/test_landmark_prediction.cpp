#include "mrpt_ext/likelihood/landmark_prediction.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_landmark_prediction
{
TEST(LandmarkPrediction, LandmarkOnTheLeft)
{
  const LandmarkPrediction p = predict({.position = {1, 4, 0}}, Reading{}, {1, 1, 0});
  EXPECT_NEAR(p.bearing, kPi / 2, 1e-12);
  EXPECT_NEAR(p.range, 3, 1e-12);
  EXPECT_EQ(p.visibility, 1);
  EXPECT_EQ(p.bearing_variance, 0);
}

TEST(LandmarkPrediction, SensorOffsetAndHeightCount)
{
  Reading reading;
  reading.T_robot_sensor = {1, 0, kPi / 2};
  reading.sensor_height = 1;
  const LandmarkPrediction p = predict({.position = {0, 5, 5}}, reading, {0, 1, kPi / 2});
  // The sensor sits at (0, 2) and looks along -x: the landmark is 3 m to its right and 4 m above it.
  EXPECT_NEAR(p.bearing, -kPi / 2, 1e-12);
  EXPECT_NEAR(p.range, 5, 1e-12);
  reading.horizontal_range = true;
  EXPECT_NEAR(predict({.position = {0, 5, 5}}, reading, {0, 1, kPi / 2}).range, 3, 1e-12);
}

TEST(LandmarkPrediction, MapUncertaintySplitsIntoAlongAndAcross)
{
  const LandmarkPrediction p = predict({.position = {2, 0, 0}, .stddev = {0.3, 0.4}}, Reading{}, {0, 0, 0});
  EXPECT_NEAR(p.range_variance, 0.09, 1e-12);
  EXPECT_NEAR(p.bearing_variance, 0.16 / 4, 1e-12);
}

TEST(LandmarkPrediction, OffsetCovarianceTurnsWithTheRobot)
{
  Reading reading;
  reading.sensor_position_covariance << 0.09, 0, 0, 0.16;  // robot axes
  const LandmarkPrediction p = predict({.position = {2, 0, 0}}, reading, {0, 0, kPi / 2});
  EXPECT_NEAR(p.range_variance, 0.16, 1e-12);
  EXPECT_NEAR(p.bearing_variance, 0.09 / 4, 1e-12);
}

TEST(LandmarkPrediction, ChanceFallsToZeroOutsideRangeAndField)
{
  Reading reading;
  reading.model = {.field_of_view = degToRad(90), .max_range = 10.0, .has_field_of_view = true};
  const auto visibility = [&](double x, double y) {
    return predict({.position = {x, y, 0}}, reading, {0, 0, 0}).visibility;
  };
  EXPECT_EQ(visibility(5, 0), 1);
  EXPECT_EQ(visibility(11, 0), 0);
  EXPECT_NEAR(visibility(10, 0), 0.5, 1e-9);
  EXPECT_EQ(visibility(0, 5), 0);
  EXPECT_NEAR(visibility(5, 5), 0.5, 1e-9);
}

TEST(LandmarkPrediction, LandmarkAtTheSensorStaysFinite)
{
  const LandmarkPrediction p = predict({.position = {1, 1, 0}, .stddev = {0.1, 0.1}}, Reading{}, {1, 1, 0.3});
  EXPECT_TRUE(std::isfinite(p.bearing) && std::isfinite(p.range_variance) && std::isfinite(p.bearing_variance));
}
}  // namespace mrpt_ext::test_landmark_prediction
