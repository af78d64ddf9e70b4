#pragma once

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// What a sensor at a given place would measure of one landmark, and how sure the map makes that.
struct LandmarkPrediction
{
  double bearing = 0;           ///< [rad] in the sensor frame, wrapped
  double range = 0;             ///< [m] slant, or horizontal where the reading says so
  double bearing_variance = 0;  ///< [rad^2] from the map and from a sensor position carried by odometry
  double range_variance = 0;    ///< [m^2] likewise
  double chance = 1;            ///< probability that the sensor reports it, before the detection probability is applied
};

/// Prediction for a reading's sensor carried by a robot at `robot` (world frame).
/// Sensor offset, height and offset covariance of the reading are applied; the chance is 1 inside the declared field of
/// view and range, 0 outside, with a ramp of 5 % of the range and 2 degrees so that weights do not jump at the rim.
[[nodiscard]] LandmarkPrediction predict(const Landmark& landmark, const Reading& reading, const Pose2& robot);
}  // namespace mrpt_ext
