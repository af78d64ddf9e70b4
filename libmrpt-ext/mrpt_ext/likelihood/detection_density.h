#pragma once

#include <algorithm>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/log_probability.h"
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
  if (detection.bearing)
    log_density += logNormal(wrap(*detection.bearing - prediction.bearing),
                             square(detection.std_bearing) + prediction.bearing_variance);
  if (detection.range)
    log_density +=
        logNormal(*detection.range - prediction.range, square(detection.std_range) + prediction.range_variance);
  return log_density;
}

/// True when every measured component is within `stds` standard deviations of its prediction.
[[nodiscard]] inline bool isWithin(const Detection& detection, const LandmarkPrediction& prediction, double stds)
{
  if (detection.bearing && square(wrap(*detection.bearing - prediction.bearing)) >
                               square(stds) * (square(detection.std_bearing) + prediction.bearing_variance))
    return false;
  return !detection.range || square(*detection.range - prediction.range) <=
                                 square(stds) * (square(detection.std_range) + prediction.range_variance);
}

/// Clutter probabilities that the estimators work with: never 0, which would make the log-likelihood of a false
/// detection infinite, and never 1, which would leave nothing to true ones.
inline constexpr double kMinClutterProbability = 1e-9, kMaxClutterProbability = 0.999;

[[nodiscard]] inline double boundedClutter(double clutter_probability)
{
  return std::clamp(clutter_probability, kMinClutterProbability, kMaxClutterProbability);
}

/// Volume V of the space that false detections are spread over evenly: the field of view [rad], the range limit [m], or
/// their product. Without a declared range limit, `default_max_range` [m] stands in. `AnyDetection`: has optional
/// `bearing` and `range`.
///
/// A search for poses treats the category as a part of the measurement, so that V counts the `categories` of the map:
/// the evidence of hypotheses that call a detection true or false is compared. The likelihood p(z) of a reading
/// conditions on the category (it selects the landmarks of the sum) and leaves `categories` at 1; the factor would be
/// the same for every pose.
template <class AnyDetection>
[[nodiscard]] double measurementVolume(const AnyDetection& detection, const SensorModel& model,
                                       double default_max_range, int categories = 1)
{
  double volume = 1;
  if (detection.bearing) volume *= model.has_field_of_view ? model.field_of_view : kTwoPi;
  if (detection.range) volume *= model.max_range.value_or(default_max_range);
  return volume * categories;
}

/// Range limit assumed for a sensor that declares none: one and a half diagonals of the map, at least 1 m.
[[nodiscard]] inline double defaultMaxRange(const Vector2d& low, const Vector2d& high)
{
  return std::max(1.0, 1.5 * (high - low).norm());
}
[[nodiscard]] inline double defaultMaxRange(const LandmarkTable& map)
{
  const auto [low, high] = map.boundingBox();
  return defaultMaxRange(low, high);
}
}  // namespace mrpt_ext
