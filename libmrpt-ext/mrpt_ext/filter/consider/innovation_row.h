#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "mrpt_ext/filter/kalman/measurement_linearization.h"
#include "mrpt_ext/geometry/frame.h"

namespace mrpt_ext
{
/// One quantity that one sensor measures.
struct ErrorKind
{
  std::size_t sensor = 0;
  bool is_bearing = false;                             ///< else a range
  auto operator<=>(const ErrorKind&) const = default;  // NOLINT(modernize-use-nullptr): a false finding of version 14
};

/// What a lasting error of a measurement belongs to: one quantity of one sensor at one landmark.
struct ErrorSource
{
  std::size_t sensor = 0;
  bool is_bearing = false;
  std::size_t landmark = 0;
  [[nodiscard]] ErrorKind kind() const { return {sensor, is_bearing}; }
  auto operator<=>(const ErrorSource&) const = default;  // NOLINT(modernize-use-nullptr): as above
};

/// A scalar measurement as the filter expected it before the update.
struct InnovationRow
{
  ErrorSource source;
  KalmanRow row;        ///< innovation, its derivative by the state, variance of the measurement
  double measured = 0;  ///< [m] or [rad]
  double variance = 1;  ///< of the innovation: H P H^T + R
};

/// Standard deviations of what is stated of a sensor, the same for all of its readings.
struct SensorStds
{
  double lever_arm = 0;               ///< [m] along each axis
  bool lever_arm_is_assumed = false;  ///< nobody stated it
  double delay = 0;                   ///< [s]
  double yaw = 0;                     ///< [rad]
};

/// One step of a linearised filter: from an error e of the estimate, those of the motion and of the measurements
/// follows the error remaining (motion_jacobian e + ...) + sum of gains[i] times the error of rows[i].
struct LinearStep
{
  double time = 0;  ///< [s]
  OdometryMotion motion;
  KalmanState before, predicted;    ///< before and after the motion
  KalmanMatrix motion_jacobian;     ///< F
  Matrix3d increment_noise;         ///< covariance of the errors that odometry makes in world and in robot axes
  KalmanMatrix information;         ///< H^T R^-1 H
  KalmanMatrix remaining;           ///< I - K H
  KalmanMatrix posterior;           ///< covariance after the measurement
  std::vector<InnovationRow> rows;  ///< outliers left out
  std::vector<KalmanVector> gains;  ///< columns of K
  std::vector<KalmanMatrix> sensor_information;  ///< the part of every sensor so far, zero without rows
  std::vector<SensorStds> sensor_stds;           ///< of every sensor so far
};
}  // namespace mrpt_ext
