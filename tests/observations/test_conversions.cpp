#include <gtest/gtest.h>
#include <mrpt/obs/CObservationBeaconRanges.h>
#include <mrpt/obs/CObservationBearingRange.h>
#include <mrpt/obs/CObservationComment.h>

#include "mrpt_ext/observations/observation_conversions.h"
#include "mrpt_ext/observations/timestamps.h"
#include "sample_observations.h"

namespace mrpt_ext::test_conversions
{
namespace
{
void expectSame(const Detection& a, const Detection& b)
{
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.category, b.category);
  EXPECT_EQ(a.bearing, b.bearing);
  EXPECT_EQ(a.range, b.range);
  EXPECT_EQ(a.std_bearing, b.std_bearing);
  EXPECT_EQ(a.std_range, b.std_range);
  ASSERT_EQ(a.facing.has_value(), b.facing.has_value());
  if (!a.facing) return;
  for (std::size_t k = 0; k < 2; ++k)
  {
    EXPECT_EQ(a.facing->attitudes[k].yaw, b.facing->attitudes[k].yaw);
    EXPECT_EQ(a.facing->attitudes[k].std, b.facing->attitudes[k].std);
    EXPECT_EQ(a.facing->attitudes[k].weight, b.facing->attitudes[k].weight);
  }
}

void expectSame(const Reading& a, const Reading& b)
{
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.sensor, b.sensor);
  EXPECT_NEAR((a.T_robot_sensor.vector() - b.T_robot_sensor.vector()).norm(), 0, 1e-12);
  EXPECT_EQ(a.sensor_height, b.sensor_height);
  EXPECT_EQ(a.horizontal_range, b.horizontal_range);
  EXPECT_EQ(a.model.has_field_of_view, b.model.has_field_of_view);
  EXPECT_EQ(a.model.field_of_view, b.model.field_of_view);
  EXPECT_EQ(a.model.max_range, b.model.max_range);
  ASSERT_EQ(a.detections.size(), b.detections.size());
  for (std::size_t i = 0; i < a.detections.size(); ++i) expectSame(a.detections[i], b.detections[i]);
}
}  // namespace

TEST(ObservationConversions, BearingsBecomeAReadingAndBack)
{
  const Reading reading = toReading(*sampleBearings());
  EXPECT_EQ(reading.sensor, "camera left");
  EXPECT_NEAR(reading.time, 1178275990.9749144, 1e-6);
  EXPECT_NEAR(reading.T_robot_sensor.phi, 0.7, 1e-12);
  EXPECT_EQ(reading.sensor_height, 0.5);
  EXPECT_TRUE(reading.model.has_field_of_view);
  EXPECT_EQ(reading.model.max_range, 8.0);
  EXPECT_EQ(reading.detections.at(0).bearing, 0.25);
  EXPECT_FALSE(reading.detections.at(0).range.has_value());
  expectSame(toReading(*toLandmarkBearings(reading)), reading);
}

TEST(ObservationConversions, RangesBecomeAReadingAndBack)
{
  const Reading reading = toReading(*sampleRanges());
  EXPECT_TRUE(reading.horizontal_range);
  EXPECT_NEAR(reading.detections.at(1).std_range, 2.0 / 60, 1e-12);
  EXPECT_FALSE(reading.detections.at(2).range.has_value());
  EXPECT_TRUE(hasRange(reading));
  expectSame(toReading(*toStereoRanges(reading)), reading);
}

TEST(ObservationConversions, FacingsBecomeAReadingAndBack)
{
  const Reading reading = toReading(*sampleFacings());
  EXPECT_EQ(reading.detections.at(0).facing->attitudes[0].yaw, 2.5);
  EXPECT_TRUE(hasFacing(reading));
  EXPECT_FALSE(hasFacing(toReading(*sampleRanges())));
  expectSame(toReading(*toStereoRanges(reading)), reading);
}

TEST(ObservationConversions, UndeclaredLimitsStayUndeclared)
{
  auto observation = sampleBearings();
  observation->field_of_view = observation->max_range = 0;
  const Reading reading = toReading(*observation);
  EXPECT_FALSE(reading.model.has_field_of_view);
  EXPECT_FALSE(reading.model.max_range.has_value());
  EXPECT_EQ(toLandmarkBearings(reading)->field_of_view, 0);
}

TEST(ObservationConversions, RunningFixBecomesPlainAndBack)
{
  const RunningFixReading fix = toRunningFix(*sampleFix());
  EXPECT_EQ(fix.first_time, 1178275988.5);
  EXPECT_EQ(fix.id, 9);
  EXPECT_EQ(fix.displacement_covariance(0, 1), 0.002);
  EXPECT_EQ(fix.second_bearing, 0.75);
  const RunningFixReading again = toRunningFix(*toObservation(fix));
  EXPECT_EQ(again.time, fix.time);
  EXPECT_EQ(again.first_time, fix.first_time);
  EXPECT_EQ(again.first_range, fix.first_range);
  EXPECT_EQ(again.second_std, fix.second_std);
  EXPECT_EQ(again.displacement.vector(), fix.displacement.vector());
  EXPECT_EQ(again.displacement_covariance, fix.displacement_covariance);
  EXPECT_EQ(again.second_bearing_std, fix.second_bearing_std);
}

TEST(ObservationConversions, BearingRangeReadsZeroRangeAsNotMeasured)
{
  mrpt::obs::CObservationBearingRange observation;
  observation.sensor_std_range = 0.5F;
  observation.sensor_std_yaw = 0.25F;
  observation.sensedData.push_back({.range = 2.0F, .yaw = 0.5F, .pitch = 0, .landmarkID = 3, .covariance = {}});
  observation.sensedData.push_back({.range = 0.0F, .yaw = -0.5F, .pitch = 0, .landmarkID = -1, .covariance = {}});
  const Reading reading = toReading(observation);
  EXPECT_EQ(reading.sensor, "bearing_range");
  EXPECT_FALSE(reading.model.has_field_of_view);
  EXPECT_EQ(reading.detections.at(0).range, 2.0);
  EXPECT_EQ(reading.detections.at(0).std_range, 0.5);
  EXPECT_EQ(reading.detections.at(0).std_bearing, 0.25);
  EXPECT_FALSE(reading.detections.at(1).range.has_value());
  EXPECT_EQ(reading.detections.at(1).id, kNoId);
}

TEST(ObservationConversions, BearingRangeUsesItsOwnCovariances)
{
  mrpt::obs::CObservationBearingRange observation;
  observation.validCovariances = true;
  observation.maxSensorDistance = 10;
  observation.fieldOfView_yaw = 2;
  observation.sensedData.push_back({.range = 2.0F, .yaw = 0.5F, .pitch = 0, .landmarkID = 3, .covariance = {}});
  observation.sensedData[0].covariance.setDiagonal(std::vector<double>{0.04, 0.0009, 1});
  const Reading reading = toReading(observation);
  EXPECT_DOUBLE_EQ(reading.detections.at(0).std_range, 0.2);
  EXPECT_DOUBLE_EQ(reading.detections.at(0).std_bearing, 0.03);
  EXPECT_TRUE(reading.model.has_field_of_view);
  EXPECT_EQ(reading.model.max_range, 10.0);
}

TEST(ObservationConversions, BeaconRangesMakeOneReadingPerAntenna)
{
  mrpt::obs::CObservationBeaconRanges observation;
  observation.stdError = 0.125F;
  for (const double antenna_x : {0.1, 0.3, 0.1})
  {
    mrpt::obs::CObservationBeaconRanges::TMeasurement measurement;
    measurement.sensorLocationOnRobot = {antenna_x, 0.0, 1.0};
    measurement.sensedDistance = 4;
    measurement.beaconID = 7;
    observation.sensedData.push_back(measurement);
  }
  const auto readings = toReadings(observation);
  ASSERT_EQ(readings.size(), 2U);
  EXPECT_EQ(readings[0].detections.size(), 2U);
  EXPECT_EQ(readings[1].T_robot_sensor.x, 0.3);
  EXPECT_EQ(readings[1].sensor_height, 1.0);
  EXPECT_EQ(readings[1].sensor, "beacons");
  EXPECT_EQ(readings[1].detections.at(0).std_range, 0.125);
}

TEST(ObservationConversions, OnlyLandmarkClassesGiveMeasurements)
{
  for (const auto& observation : samplesOfAllClasses()) EXPECT_TRUE(toMeasurements(*observation).has_value());
  EXPECT_FALSE(toMeasurements(mrpt::obs::CObservationComment()).has_value());
}

TEST(ObservationConversions, AnEmptyLabelIsDerivedFromTheClass)
{
  auto observation = sampleBearings();
  EXPECT_EQ(labelOf(*observation), "camera left");
  observation->sensorLabel.clear();
  EXPECT_EQ(labelOf(*observation), "bearings");
  EXPECT_EQ(shortClassName(*observation), "CObservationLandmarkBearings");
}
}  // namespace mrpt_ext::test_conversions
