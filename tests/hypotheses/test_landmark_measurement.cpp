#include "mrpt_ext/hypotheses/landmark_measurement.h"

#include <gtest/gtest.h>

#include "exact_scene.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_landmark_measurement
{
namespace
{
/// A landmark two metres above the floor, a sensor half a metre above it.
const LandmarkTable kHigh({{.id = 1, .position = {2, 0, 2}, .stddev = {0.03, 0.04}}, {.id = 2, .position = {0, 5, 1}}});

Reading readingOf(Detection detection)
{
  Reading reading{.sensor = "eye", .sensor_height = 0.5};
  reading.detections = {std::move(detection)};
  return reading;
}
}  // namespace

TEST(LandmarkMeasurement, SlantRangesAreReducedToThePlane)
{
  const auto seen = identifiedMeasurements({{readingOf({.id = 1, .range = 2.5, .std_range = 0.12})}}, kHigh);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].landmark, 0u);
  EXPECT_EQ(seen[0].position, Vector2d(2, 0));
  EXPECT_NEAR(*seen[0].range, 2.0, 1e-12);  // 2.5^2 = 2.0^2 + 1.5^2
  // d horizontal / d slant = 2.5 / 2.0; the landmark's own standard deviation adds.
  EXPECT_NEAR(seen[0].std_range, std::hypot(0.15, 0.04), 1e-12);
}

TEST(LandmarkMeasurement, HorizontalRangesStay)
{
  Reading reading = readingOf({.id = 1, .range = 2.5, .std_range = 0.12});
  reading.horizontal_range = true;
  const auto seen = identifiedMeasurements({{reading}}, kHigh);
  EXPECT_EQ(*seen[0].range, 2.5);
  EXPECT_NEAR(seen[0].std_range, std::hypot(0.12, 0.04), 1e-12);
}

TEST(LandmarkMeasurement, ARangeShorterThanTheHeightIsLeftOutItsBearingKept)
{
  const Reading alone = readingOf({.id = 1, .range = 1.4, .std_range = 0.1});
  EXPECT_TRUE(identifiedMeasurements({{alone}}, kHigh).empty());
  const auto seen =
      identifiedMeasurements({{readingOf({.id = 1, .bearing = 0.3, .range = 1.4, .std_bearing = 0.02})}}, kHigh);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].bearing, 0.3);
  EXPECT_FALSE(seen[0].range);
  EXPECT_FALSE(seen[0].hasPoint());
}

TEST(LandmarkMeasurement, AnUncertainSensorPositionInflatesRangeAndBearing)
{
  Reading reading = readingOf({.id = 2, .bearing = 0.0, .range = 4, .std_bearing = 0.03, .std_range = 0.05});
  reading.horizontal_range = true;
  reading.sensor_position_covariance = Vector2d(0.01, 0.04).asDiagonal();
  const auto seen = identifiedMeasurements({{reading}}, kHigh);
  EXPECT_NEAR(seen[0].std_range, std::hypot(0.05, 0.2), 1e-12);
  EXPECT_NEAR(seen[0].std_bearing, std::hypot(0.03, 0.2 / 4), 1e-12);
}

TEST(LandmarkMeasurement, UnknownIdsAreNeitherIdentifiedNorAnonymous)
{
  const Reading reading = readingOf({.id = 99, .bearing = 1.0, .std_bearing = 0.1});
  EXPECT_TRUE(identifiedMeasurements({{reading}}, kHigh).empty());
  EXPECT_TRUE(anonymousMeasurements({{reading}}, kHigh).empty());
}

TEST(LandmarkMeasurement, AnonymousOnesKeepTheirCategoryAndUseTheMeanHeight)
{
  const double dz = 1.5 - 0.5;
  const auto seen =
      anonymousMeasurements({{readingOf({.category = "red", .range = std::hypot(3.0, dz), .std_range = 0.1})}}, kHigh);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_FALSE(seen[0].landmark);
  EXPECT_EQ(seen[0].category, "red");
  EXPECT_NEAR(*seen[0].range, 3, 1e-12);
  EXPECT_EQ(anonymousMeasurements({{readingOf({.range = 2})}}, LandmarkTable{}).size(), 1u);
}

TEST(LandmarkMeasurement, ThePointIsTheLandmark)
{
  const ExactSensor sensor{.range = true, .T_robot_sensor = {0.3, -0.2, 1.1}, .height = 0.5};
  const Pose2 robot{1, 2, 0.4};
  for (const LandmarkMeasurement& s : identifiedMeasurements({{seenFrom(robot, kHigh, {0, 1}, sensor)}}, kHigh))
    EXPECT_LT((transform(robot, s.pointInRobot()) - s.position).norm(), 1e-9);
}

TEST(LandmarkMeasurement, TheCovarianceOfThePointIsThatOfNoisyMeasurements)
{
  LandmarkMeasurement s{.T_robot_sensor = {0.3, -0.2, 1.1}, .bearing = 0.5, .range = 3, .std_bearing = 0.02};
  s.std_range = 0.15;
  RandomStream random(8);
  Matrix2d sampled = Matrix2d::Zero();
  constexpr int kCount = 40000;
  for (int i = 0; i < kCount; ++i)
  {
    LandmarkMeasurement noisy = s;
    *noisy.bearing += s.std_bearing * random.gaussian();
    *noisy.range += s.std_range * random.gaussian();
    const Vector2d d = noisy.pointInRobot() - s.pointInRobot();
    sampled += d * d.transpose() / kCount;
  }
  EXPECT_LT((sampled - s.pointCovariance()).norm(), 0.03 * sampled.norm());
}

TEST(LandmarkMeasurement, PoseMeasurementsHaveNoResidualAtTheTruth)
{
  const ExactSensor sensor{.range = true, .T_robot_sensor = {0.3, -0.2, 1.1}, .height = 0.5};
  const Pose2 robot{1, 2, 0.4};
  const auto rows = poseMeasurements(identifiedMeasurements({{seenFrom(robot, kHigh, {0, 1}, sensor)}}, kHigh));
  ASSERT_EQ(rows.size(), 4u);
  for (const PoseMeasurement& row : rows) EXPECT_NEAR(residual(row, robot), 0, 1e-9);
}

TEST(LandmarkMeasurement, ACertainFacingIsAHeading)
{
  const LandmarkTable map({{.id = 1, .position = {2, 0, 0}, .yaw = 2.0}});
  Reading reading = readingOf({.id = 1, .bearing = 0.3, .std_bearing = 0.01});
  reading.T_robot_sensor.phi = 0.5;
  const auto headingsOf = [&](const Facing& facing)
  {
    reading.detections[0].facing = facing;
    const auto measurements = identifiedMeasurements({&reading, 1}, map);
    EXPECT_TRUE(measurements.at(0).headings);
    std::vector<PoseMeasurement> rows = poseMeasurements(measurements);
    std::erase_if(rows, [](const PoseMeasurement& m) { return m.kind != PoseMeasurement::Kind::heading; });
    return rows;
  };
  const auto certain = headingsOf(Facing::single(1.2, 0.1));
  ASSERT_EQ(certain.size(), 1U);
  EXPECT_NEAR(certain[0].value, 0.3, 1e-12);
  EXPECT_EQ(certain[0].std, 0.1);
  EXPECT_EQ(headingsOf(Facing::either({1.2, 0.1}, {2, 0.1}, 0.005)).size(), 1U);
  EXPECT_TRUE(headingsOf(Facing::either({1.2, 0.1}, {2, 0.1}, 0.02)).empty());
}

TEST(LandmarkMeasurement, CountsDifferentLandmarks)
{
  const auto seen = identifiedMeasurements({{seenFrom({}, kHigh, {0, 0, 1, 0}, {})}}, kHigh);
  EXPECT_EQ(distinctLandmarks(seen, [](const LandmarkMeasurement&) { return true; }), 2u);
  EXPECT_EQ(distinctLandmarks(seen, [](const LandmarkMeasurement& s) { return s.landmark == 1u; }), 1u);
  EXPECT_EQ(distinctLandmarks(seen, [](const LandmarkMeasurement& s) { return s.range.has_value(); }), 0u);
}

TEST(LandmarkMeasurement, FixesAreReducedToThePlaneToo)
{
  RunningFixReading fix{.sensor_height = 0.5, .id = 1};
  fix.first_range = 2.5;
  fix.first_std = fix.second_std = 0.1;
  fix.second_range = std::hypot(4.0, 1.5);
  ASSERT_TRUE(reduceToHorizontal(fix, 2));
  EXPECT_TRUE(fix.horizontal_range);
  EXPECT_NEAR(fix.first_range, 2, 1e-12);
  EXPECT_NEAR(fix.first_std, 0.125, 1e-12);
  EXPECT_NEAR(fix.second_range, 4, 1e-12);
  ASSERT_TRUE(reduceToHorizontal(fix, 2));  // it already is
  EXPECT_NEAR(fix.first_range, 2, 1e-12);
  RunningFixReading impossible{.sensor_height = 0.5, .first_range = 2.5, .second_range = 1.4};
  EXPECT_FALSE(reduceToHorizontal(impossible, 2));
}
}  // namespace mrpt_ext::test_landmark_measurement
