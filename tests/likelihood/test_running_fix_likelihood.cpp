#include "mrpt_ext/likelihood/running_fix_likelihood.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mrpt_ext/likelihood/landmark_prediction.h"
#include "mrpt_ext/likelihood/reading_likelihood.h"

namespace mrpt_ext::test_running_fix_likelihood
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {0, 0, 0}}});

RunningFixReading exampleFix()
{
  RunningFixReading fix;
  fix.sensor = "stereo";
  fix.id = 1;
  fix.first_range = 5;
  fix.first_std = 0.1;
  fix.second_range = 4;
  fix.second_std = 0.1;
  fix.displacement = {3, 0, kPi / 2};
  fix.displacement_covariance.diagonal() << 0.04, 0.01, 0;
  return fix;
}
}  // namespace

TEST(RunningFixLikelihood, FirstRangeIsTakenFromWhereTheRobotWas)
{
  const std::vector<Reading> readings = asReadings(exampleFix());
  ASSERT_EQ(readings.size(), 2U);
  const Pose2 first{1, 2, 0.3}, second = compose(first, exampleFix().displacement);
  EXPECT_NEAR(predict(kMap[0], readings[0], second).range, std::hypot(1, 2), 1e-9);
  EXPECT_NEAR(predict(kMap[0], readings[1], second).range, std::hypot(second.x, second.y), 1e-9);
}

TEST(RunningFixLikelihood, DisplacementErrorGrowsTheFirstVarianceAlongTheLineOfSight)
{
  const std::vector<Reading> readings = asReadings(exampleFix());
  // First pose 5 m from the landmark, which lies straight ahead: only the forward error of the displacement counts.
  const Pose2 first{-5, 0, 0}, second = compose(first, exampleFix().displacement);
  EXPECT_NEAR(predict(kMap[0], readings[0], second).range_variance, 0.04, 1e-9);
  const Pose2 sideways{-5, 0, kPi / 2}, second_sideways = compose(sideways, exampleFix().displacement);
  EXPECT_NEAR(predict(kMap[0], readings[0], second_sideways).range_variance, 0.01, 1e-9);
}

TEST(RunningFixLikelihood, ATurnErrorSwingsTheSensorNotTheRobotsCentre)
{
  RunningFixReading fix = exampleFix();
  fix.T_robot_sensor = {0.5, -0.2, 0};
  fix.displacement_covariance.diagonal() << 0, 0, 1e-4;
  constexpr double kTurn = 1e-6;
  RunningFixReading turned = fix;
  turned.displacement.phi += kTurn;
  const Vector2d swing =
      (asReadings(turned)[0].T_robot_sensor.position() - asReadings(fix)[0].T_robot_sensor.position()) / kTurn;
  EXPECT_TRUE(asReadings(fix)[0].sensor_position_covariance.isApprox(1e-4 * swing * swing.transpose(), 1e-4));
}

TEST(RunningFixLikelihood, WhatIsNoCovarianceDoesNotMakeAVarianceNegative)
{
  RunningFixReading fix = exampleFix();
  fix.displacement_covariance.diagonal() << -1, -1, 0;
  for (const Reading& reading : asReadings(fix)) EXPECT_TRUE(std::isfinite(logLikelihood(reading, kMap, {1, 2, 0.3})));
}

TEST(RunningFixLikelihood, BearingIsScoredWithTheSecondRangeOnly)
{
  RunningFixReading fix = exampleFix();
  fix.second_bearing = 0.2;
  fix.second_bearing_std = 0.02;
  const std::vector<Reading> readings = asReadings(fix);
  EXPECT_FALSE(readings[0].detections[0].bearing.has_value());
  EXPECT_EQ(readings[1].detections[0].bearing, 0.2);
}
}  // namespace mrpt_ext::test_running_fix_likelihood
