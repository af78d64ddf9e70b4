#pragma once

#include <array>

#include "mrpt_ext/filter/kalman/kalman_state.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// One scalar measurement, linearised: residual = measured - predicted, jacobian = d predicted / d state.
struct KalmanRow
{
  KalmanRowVector jacobian;
  double residual = 0;  ///< bearings wrapped
  double variance = 1;  ///< of the sensor, the map and the odometry between a past scan and now
};

/// The rows of one detection, if it shows one given landmark: bearing, range or both.
struct DetectionRows
{
  std::array<KalmanRow, 2> rows;
  int count = 0;
  double chance = 1;  ///< that the sensor reports this landmark from there at all
};

/// Linearises at `mean`: sensor offset, slant range, systematic errors of the sensor, deviations of the landmark.
[[nodiscard]] DetectionRows linearise(const Detection& detection, const Reading& reading, const Landmark& landmark,
                                      const KalmanVector& mean, const BiasModel& biases);

/// A heading measured by a compass.
[[nodiscard]] KalmanRow lineariseHeading(double heading, double std_heading, const KalmanVector& mean);
}  // namespace mrpt_ext
