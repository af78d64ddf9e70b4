#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// One turn of a laser scanner: ranges in the plane, at evenly spaced bearings, and how strong each echo was.
struct RangeScan
{
  double time = 0;  ///< [s]
  std::string sensor;
  Pose2 T_robot_sensor;
  double sensor_height = 0;        ///< [m] above the floor
  double first_bearing = 0;        ///< [rad] CCW from the sensor's forward axis
  double bearing_step = 0;         ///< [rad] from beam to beam; negative: clockwise
  double std_range = 0;            ///< [m] of a range
  std::vector<float> ranges;       ///< [m], 0 where there is no echo
  std::vector<float> intensities;  ///< in units of the scanner; as many as ranges, or none
};

/// Bearing of a beam [rad].
[[nodiscard]] inline double bearingOf(const RangeScan& scan, std::size_t beam)
{
  return scan.first_bearing + scan.bearing_step * static_cast<double>(beam);
}
}  // namespace mrpt_ext
