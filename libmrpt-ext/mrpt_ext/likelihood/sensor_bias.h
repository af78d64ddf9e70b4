#pragma once

#include <string_view>

#include "mrpt_ext/likelihood/landmark_prediction.h"
#include "mrpt_ext/likelihood/pose_batch.h"

namespace mrpt_ext
{
/// Systematic errors of one sensor: measured range = (1 + scale) true range + offset, measured bearing = true + offset.
struct SensorBias
{
  double range_offset = 0;    ///< [m]
  double range_scale = 0;     ///< relative
  double bearing_offset = 0;  ///< [rad]
};

/// Adds one error of this kind; those of odometry do not concern a sensor.
inline void accumulate(SensorBias& bias, BiasKind kind, double value)
{
  if (kind == BiasKind::range_offset) bias.range_offset += value;
  if (kind == BiasKind::range_scale) bias.range_scale += value;
  if (kind == BiasKind::bearing_offset) bias.bearing_offset += value;
}

/// The errors that pose i of the batch ascribes to the sensor with this label.
[[nodiscard]] inline SensorBias sensorBias(const PoseBatch& robots, std::size_t i, std::string_view sensor)
{
  SensorBias result;
  for (std::size_t k = 0; k < robots.bias_states.size(); ++k)
    if (actsOn(robots.bias_states[k], sensor)) accumulate(result, robots.bias_states[k].kind, robots.bias[k][i]);
  return result;
}

/// Turns the true measurement into the reported one. Visibility and variances stay those of the true one.
inline void applyBias(LandmarkPrediction& prediction, const SensorBias& bias)
{
  prediction.bearing = wrap(prediction.bearing + bias.bearing_offset);
  prediction.range = (1 + bias.range_scale) * prediction.range + bias.range_offset;
}
}  // namespace mrpt_ext
