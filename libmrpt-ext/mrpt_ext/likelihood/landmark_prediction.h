#pragma once

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// Predicted measurement of one landmark, with the variance that the map and the sensor position add.
struct LandmarkPrediction
{
  double bearing = 0;           ///< [rad] in the sensor frame, wrapped
  double range = 0;             ///< [m] slant, or horizontal if Reading::horizontal_range
  double bearing_variance = 0;  ///< [rad^2] from the map and from the position of a past sensor (Reading)
  double range_variance = 0;    ///< [m^2] likewise
  double visibility = 1;        ///< probability that the sensor reports it, before the detection probability is applied
};

/// Prediction for the reading's sensor on a robot at `robot` (world frame).
/// Sensor offset, height and position covariance of the reading are applied. The visibility is 1 inside the declared
/// field of view and range, 0 outside, with a ramp of 5 % of the range and 2 degrees so that weights do not jump at the
/// rim.
[[nodiscard]] LandmarkPrediction predict(const Landmark& landmark, const Reading& reading, const Pose2& robot);
}  // namespace mrpt_ext
