#pragma once

#include <algorithm>
#include <vector>

#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// Clutter probability per landmark of the map, in the order of the table; empty: the sensor's own value for all.
/// With it a filter trusts a faulty beacon less than its neighbours.
using LandmarkClutter = std::vector<double>;

/// Of one landmark; never 0, which keeps every log-likelihood finite.
[[nodiscard]] inline double clutterOf(const LandmarkClutter& clutter, const SensorModel& model, std::size_t landmark)
{
  constexpr double kMinClutter = 1e-9;
  return std::clamp(clutter.empty() ? model.clutter_probability : clutter[landmark], kMinClutter, 1.0);
}
}  // namespace mrpt_ext
