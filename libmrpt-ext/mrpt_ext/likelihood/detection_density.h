#pragma once

#include <algorithm>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/likelihood/landmark_prediction.h"

namespace mrpt_ext
{
/// True when a detection may show this landmark: same id, else same category, else any.
/// A detection with an id that the map does not know matches nothing.
[[nodiscard]] inline bool mayShow(const Detection& detection, const Landmark& landmark)
{
  if (detection.id != kNoId) return detection.id == landmark.id;
  return detection.category.empty() || detection.category == landmark.category;
}

/// True when some landmark of the map may have given the detection.
[[nodiscard]] inline bool mayShowAny(const Detection& detection, const LandmarkTable& map)
{
  return std::any_of(map.all().begin(), map.all().end(),
                     [&](const Landmark& landmark) { return mayShow(detection, landmark); });
}

/// Natural logarithm of N(z; h, R) over the measured components (bearing, range or both, taken as independent).
[[nodiscard]] inline double logDensity(const Detection& detection, const LandmarkPrediction& prediction)
{
  double log_density = 0;
  const auto add = [&log_density](double residual, double variance)
  { log_density -= 0.5 * (residual * residual / variance + std::log(kTwoPi * variance)); };
  if (detection.bearing)
    add(wrap(*detection.bearing - prediction.bearing), square(detection.std_bearing) + prediction.bearing_variance);
  if (detection.range)
    add(*detection.range - prediction.range, square(detection.std_range) + prediction.range_variance);
  return log_density;
}

/// Volume V of the space a false detection is spread over: the field of view [rad], the range limit [m], or their
/// product. Without a declared range limit, `default_max_range` [m] stands in.
[[nodiscard]] inline double measurementVolume(const Detection& detection, const SensorModel& model,
                                              double default_max_range)
{
  double volume = 1;
  if (detection.bearing) volume *= model.has_field_of_view ? model.field_of_view : kTwoPi;
  if (detection.range) volume *= model.max_range.value_or(default_max_range);
  return volume;
}

/// Range limit assumed for a sensor that declares none: one and a half diagonals of the map, at least 1 m.
[[nodiscard]] inline double defaultMaxRange(const LandmarkTable& map)
{
  const auto [low, high] = map.boundingBox();
  return std::max(1.0, 1.5 * (high - low).norm());
}
}  // namespace mrpt_ext
