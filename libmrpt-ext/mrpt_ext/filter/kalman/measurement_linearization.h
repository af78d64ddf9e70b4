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
  double variance = 1;  ///< of the sensor, of the landmark, and of the odometry since a past scan
};

/// The rows of one detection, associated with one landmark: bearing, range or both.
struct DetectionRows
{
  std::array<KalmanRow, 2> rows;
  int count = 0;
  double visibility = 1;  ///< probability that the landmark is in view (LandmarkPrediction::visibility)
};

/// Linearises at `mean`. Accounts for the mounting of the sensor, slant range, systematic errors of the sensor and the
/// standard deviations of the landmark.
[[nodiscard]] DetectionRows linearise(const Detection& detection, const Reading& reading, const Landmark& landmark,
                                      const KalmanVector& mean, const BiasModel& biases);

/// The row of a heading that a compass measured.
[[nodiscard]] KalmanRow lineariseHeading(double heading, double std_heading, const KalmanVector& mean);
}  // namespace mrpt_ext
