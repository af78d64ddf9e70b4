#include "mrpt_ext/calibration/measurement_times.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "recorded_drive.h"

namespace mrpt_ext::test_measurement_times
{
namespace
{
/// Two sensors with the same readings, the second one later.
CalibrationProblem twoSensors()
{
  RandomStream random(1);
  CalibrationProblem problem = testing::recordedDrive({.duration = 20}, random);
  problem.sensors = 2;
  for (std::size_t i = 0; i < problem.readings.size(); ++i) problem.readings[i].sensor = i % 2;
  return problem;
}
}  // namespace

TEST(MeasurementTimes, PosesAreWhereAndWhenTheirReadingsWereMeasured)
{
  const CalibrationProblem problem = twoSensors();
  const std::vector<double> delays{0, 0.27};
  const MeasuredRecording moved = atMeasurementTimes(problem, delays);
  ASSERT_EQ(moved.problem.readings.size(), problem.readings.size());
  const OdometryPath path(problem.odometry, {});
  for (std::size_t i = 0; i < moved.readings.size(); ++i)
  {
    const CalibrationReading& now = moved.problem.readings[i];
    const CalibrationReading& then = problem.readings[moved.readings[i]];
    EXPECT_EQ(now.value, then.value);
    const TrajectoryPose &pose = moved.problem.poses[now.pose], &stamped = problem.poses[then.pose];
    EXPECT_NEAR(pose.time, stamped.time - delays[now.sensor], 1e-9);
    const Pose2 back = between(path.at(stamped.time), path.at(pose.time));
    EXPECT_LT((pose.pose.position() - compose(stamped.pose, back).position()).norm(), 1e-9);
  }
  const auto& poses = moved.problem.poses;
  EXPECT_TRUE(std::is_sorted(poses.begin(), poses.end(), [](const auto& a, const auto& b) { return a.time < b.time; }));
  const auto& readings = moved.problem.readings;
  EXPECT_TRUE(
      std::is_sorted(readings.begin(), readings.end(), [](const auto& a, const auto& b) { return a.pose < b.pose; }));
}

TEST(MeasurementTimes, TheNoiseOfOdometryIsThatOfTheTimeBetween)
{
  const CalibrationProblem problem = twoSensors();
  const MeasuredRecording moved = atMeasurementTimes(problem, {0, 0.27});
  const double rate =
      scattered(*problem.poses[1].since_previous)(2, 2) / (problem.poses[1].time - problem.poses[0].time);
  for (std::size_t k = 1; k < moved.problem.poses.size(); ++k)
  {
    const double seconds = moved.problem.poses[k].time - moved.problem.poses[k - 1].time;
    ASSERT_TRUE(moved.problem.poses[k].since_previous);
    EXPECT_NEAR(scattered(*moved.problem.poses[k].since_previous)(2, 2), rate * seconds, 1e-9);
  }
}

TEST(MeasurementTimes, ABreakStaysABreak)
{
  CalibrationProblem problem = twoSensors();
  problem.poses[50].since_previous.reset();
  const MeasuredRecording moved = atMeasurementTimes(problem, {0.05, 0.05});
  ASSERT_EQ(moved.problem.poses.size(), problem.poses.size());
  EXPECT_FALSE(moved.problem.poses[50].since_previous);
}
}  // namespace mrpt_ext::test_measurement_times
