#include "mrpt_ext/frames/scan_skew.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext::test_scan_skew
{
namespace
{
const LandmarkTable kMap({{.id = 1, .position = {4, 1, 0}},
                          {.id = 2, .position = {-2, 3, 0}},
                          {.id = 3, .position = {1, -5, 0}},
                          {.id = 4, .position = {-6, -1, 0}}});
const Pose2 kMount{0.2, 0.1, 0.5};
constexpr double kStamp = 3;

/// A robot on a circle: 1 m/s ahead, 2 rad/s to the left; or turning on the spot.
Pose2 poseAt(double time, double speed)
{
  const double a = 2 * time;
  return {0.5 * speed * std::sin(a), 0.5 * speed * (1 - std::cos(a)), wrap(a)};
}

OdometryPath odometryOf(double speed)
{
  OdometryPath path;
  for (int k = 0; k <= 4000; ++k) path.add({0.001 * k, poseAt(0.001 * k, speed)});
  return path;
}

/// What the scanner reports: each landmark from where the robot was when the beam met it.
Reading scanned(const ScanSweep& sweep, double speed, bool range, double field_of_view = kTwoPi)
{
  Reading reading{.time = kStamp, .sensor = "scanner", .T_robot_sensor = kMount};
  reading.model.field_of_view = field_of_view;
  for (const Landmark& landmark : kMap.all())
  {
    Detection d{.id = landmark.id};
    double age = 0, before = 0;
    for (int k = 0; k < 30; ++k)
    {
      before = age;
      const Pose2 robot = poseAt(kStamp - age, speed);
      d.bearing = predictBearing(robot, landmark.position.head<2>(), kMount);
      if (range) d.range = predictRange(robot, landmark.position.head<2>(), kMount);
      age = sweep.ageOf(*d.bearing, field_of_view);
    }
    const bool met_once = std::abs(age - before) < 1e-9;  // at the seam it may be met twice, or never
    if (met_once && std::abs(*d.bearing) < field_of_view / 2) reading.detections.push_back(d);
  }
  return reading;
}

/// Largest difference to what is seen from the pose at the stamp: bearing [rad], range [m].
Vector2d error(const Reading& reading, double speed)
{
  Vector2d most(0, 0);
  const Pose2 robot = poseAt(kStamp, speed);
  for (const Detection& d : reading.detections)
  {
    const Vector2d landmark = kMap[*kMap.indexOf(d.id)].position.head<2>();
    most[0] = std::max(most[0], std::abs(wrap(*d.bearing - predictBearing(robot, landmark, kMount))));
    if (d.range) most[1] = std::max(most[1], std::abs(*d.range - predictRange(robot, landmark, kMount)));
  }
  return most;
}
}  // namespace

TEST(ScanSkew, PointsAreAsSeenFromThePoseAtTheStamp)
{
  for (const SweepDirection direction : {SweepDirection::counterclockwise, SweepDirection::clockwise})
    for (const std::optional<double> start : {std::optional<double>{}, std::optional(0.3)})
      for (const double field_of_view : {kTwoPi, degToRad(270.0)})
      {
        if (start && field_of_view < kTwoPi) continue;
        const ScanSweep sweep{0.1, direction, start};
        Reading reading = scanned(sweep, 1, true, field_of_view);
        ASSERT_GE(reading.detections.size(), 3U);
        EXPECT_GT(error(reading, 1)[0], 0.1);
        removeScanSkew(reading, sweep, odometryOf(1));
        EXPECT_LT(error(reading, 1).maxCoeff(), 1e-4);
      }
}

TEST(ScanSkew, BearingsAreCorrectedForTheTurnAlone)
{
  const ScanSweep sweep{.duration = 0.1};
  Reading turning = scanned(sweep, 0, false), driving = scanned(sweep, 1, false);
  removeScanSkew(turning, sweep, odometryOf(0));
  EXPECT_LT(error(turning, 0)[0], 0.01) << "the sensor is beside the axis";
  removeScanSkew(driving, sweep, odometryOf(1));
  EXPECT_LT(error(driving, 1)[0], 0.1 / 3) << "0.1 m driven, 3 m away";
}

TEST(ScanSkew, WithoutADurationOrABearingNothingChanges)
{
  Reading reading = scanned({}, 1, true);
  reading.detections.push_back({.id = 1, .range = 4.0});
  Reading same = reading;
  removeScanSkew(same, {}, odometryOf(1));
  for (std::size_t d = 0; d < reading.detections.size(); ++d)
    EXPECT_EQ(same.detections[d].bearing, reading.detections[d].bearing);
  removeScanSkew(same, {.duration = 0.1}, odometryOf(1));
  EXPECT_EQ(same.detections.back().range, 4.0);
  EXPECT_FALSE(same.detections.back().bearing);
}
}  // namespace mrpt_ext::test_scan_skew
