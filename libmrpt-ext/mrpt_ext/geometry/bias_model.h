#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mrpt_ext
{
/// A systematic error that an estimator may estimate beside the pose.
enum class BiasKind
{
  range_offset,    ///< [m] measured range = (1 + scale) true range + offset
  range_scale,     ///< relative, 0 = as measured
  bearing_offset,  ///< [rad] measured bearing = true bearing + offset
  distance_scale,  ///< relative error of odometry: true = (1 + scale) * measured distance
  rotation_scale,  ///< relative error of odometry: true = (1 + scale) * measured rotation
  arc_scale,       ///< ... of rotations while the robot drives, on top of rotation_scale
  veer,            ///< [rad/m] true heading minus measured one, gained per metre
  drift            ///< [rad/s] true heading minus measured one, gained per second
};

/// One such error: Gaussian prior, then a random walk.
struct BiasState
{
  BiasKind kind = BiasKind::range_offset;
  std::string sensor;         ///< label of the sensor it belongs to; empty: all sensors (and odometry)
  double mean = 0;            ///< of the prior, in the unit of the kind
  double std = 0;             ///< of the prior; 0: known, not estimated
  double std_per_sqrt_s = 0;  ///< random walk: standard deviation after one second
};

/// The errors estimated together with the pose, in the order of the estimator's extra state components.
using BiasModel = std::vector<BiasState>;

/// True for the errors of odometry.
[[nodiscard]] inline bool belongsToOdometry(BiasKind kind) { return kind >= BiasKind::distance_scale; }

/// True when the error acts on readings of the sensor with this label: its own label, or one that continues it after
/// a dot ("camera" acts on "camera.4").
[[nodiscard]] inline bool actsOn(const BiasState& bias, std::string_view sensor)
{
  if (belongsToOdometry(bias.kind)) return false;
  const bool begins = sensor.starts_with(bias.sensor);
  return bias.sensor.empty() || (begins && (sensor.size() == bias.sensor.size() || sensor[bias.sensor.size()] == '.'));
}
}  // namespace mrpt_ext
