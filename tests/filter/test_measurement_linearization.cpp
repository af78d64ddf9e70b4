#include "mrpt_ext/filter/kalman/measurement_linearization.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace mrpt_ext::test_measurement_linearization
{
namespace
{
const BiasModel kBiases{{.kind = BiasKind::range_offset, .mean = 0.1},
                        {.kind = BiasKind::range_scale, .sensor = "eye", .mean = 0.05},
                        {.kind = BiasKind::bearing_offset, .sensor = "eye", .mean = 0.02},
                        {.kind = BiasKind::bearing_offset, .sensor = "other", .mean = 1},
                        {.kind = BiasKind::distance_scale, .mean = 0.3}};

Reading readingOf(const Pose2& T_robot_sensor, double height)
{
  Reading reading;
  reading.sensor = "eye";
  reading.T_robot_sensor = T_robot_sensor;
  reading.sensor_height = height;
  return reading;
}

double drawn(double low, double high) { return low + (high - low) * 1e-6 * *rc::gen::inRange(0, 1000001); }
}  // namespace

TEST(MeasurementLinearization, ThePredictionContainsTheSystematicErrorsOfTheSensor)
{
  const KalmanState state = startingState({{0, 0, 0}, Matrix3d::Identity()}, kBiases);
  const Landmark landmark{.id = 1, .position = {3, 4, 0}};
  const Detection detection{.bearing = 1, .range = 6, .std_bearing = 0.1, .std_range = 0.2};
  const DetectionRows rows = linearise(detection, readingOf({}, 0), landmark, state.mean, kBiases);
  ASSERT_EQ(rows.count, 2);
  EXPECT_NEAR(rows.rows[0].residual, 1 - (std::atan2(4, 3) + 0.02), 1e-12);
  EXPECT_NEAR(rows.rows[1].residual, 6 - (1.05 * 5 + 0.1), 1e-12);
  EXPECT_NEAR(rows.rows[1].variance, 0.04, 1e-12);
  EXPECT_EQ(rows.rows[0].jacobian[5], 1);
  EXPECT_EQ(rows.rows[0].jacobian[6], 0) << "of another sensor";
  EXPECT_EQ(rows.rows[1].jacobian[3], 1);
  EXPECT_NEAR(rows.rows[1].jacobian[4], 5, 1e-12);
  EXPECT_EQ(rows.rows[1].jacobian[7], 0) << "of odometry";
}

TEST(MeasurementLinearization, TheVarianceContainsTheStandardDeviationsOfTheLandmark)
{
  const KalmanState state = startingState({}, {});
  const Landmark landmark{.id = 1, .position = {2, 0, 0}, .stddev = {0.3, 0.4}};
  const Detection detection{.bearing = 0, .range = 2, .std_bearing = 0.1, .std_range = 0.2};
  const DetectionRows rows = linearise(detection, readingOf({}, 0), landmark, state.mean, {});
  EXPECT_NEAR(rows.rows[0].variance, 0.01 + square(0.4 / 2), 1e-9);
  EXPECT_NEAR(rows.rows[1].variance, 0.04 + square(0.3), 1e-9);
}

TEST(MeasurementLinearization, ACompassHeadingIsOneRow)
{
  KalmanState state = startingState({{0, 0, 3}, Matrix3d::Identity()}, {});
  const KalmanRow row = lineariseHeading(-3, 0.1, state.mean);
  EXPECT_NEAR(row.residual, kTwoPi - 6, 1e-12);
  EXPECT_NEAR(row.variance, 0.01, 1e-15);
}

RC_GTEST_PROP(MeasurementLinearization, JacobiansAreTheDerivativesOfThePredictions, ())
{
  const Pose2 pose{drawn(-5, 5), drawn(-5, 5), drawn(-3, 3)};
  const Reading reading = readingOf({drawn(-0.3, 0.3), drawn(-0.3, 0.3), drawn(-3, 3)}, drawn(0, 2));
  const Landmark landmark{.id = 1, .position = {drawn(6, 9), drawn(-9, 9), drawn(0, 2)}};
  const Detection detection{.bearing = 0, .range = 5, .std_bearing = 0.1, .std_range = 0.1};
  const KalmanState state = startingState({pose, Matrix3d::Identity()}, kBiases);
  const DetectionRows here = linearise(detection, reading, landmark, state.mean, kBiases);
  constexpr double kStep = 1e-5;
  for (int k = 0; k < state.mean.size(); ++k)
  {
    KalmanVector up = KalmanVector::Zero(state.mean.size());
    up[k] = kStep;
    const DetectionRows ahead = linearise(detection, reading, landmark, moved(state.mean, up), kBiases);
    const DetectionRows behind = linearise(detection, reading, landmark, moved(state.mean, -up), kBiases);
    const double bearing = wrap(behind.rows[0].residual - ahead.rows[0].residual) / (2 * kStep);
    const double range = (behind.rows[1].residual - ahead.rows[1].residual) / (2 * kStep);
    RC_ASSERT(std::abs(bearing - here.rows[0].jacobian[k]) < 1e-6);
    RC_ASSERT(std::abs(range - here.rows[1].jacobian[k]) < 1e-5);
  }
}
}  // namespace mrpt_ext::test_measurement_linearization
