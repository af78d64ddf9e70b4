#pragma once

#include <vector>

#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
/// Clutter probability per landmark of the map, in the order of the table; empty: the sensor's own value for all.
/// With it a filter trusts a faulty beacon less than its neighbours.
using LandmarkClutter = std::vector<double>;

/// Clutter probability of one landmark, within the bounds of detection_density.h.
[[nodiscard]] inline double clutterOf(const LandmarkClutter& clutter, const SensorModel& model, std::size_t landmark)
{
  return boundedClutter(clutter.empty() ? model.clutter_probability : clutter[landmark]);
}
}  // namespace mrpt_ext
