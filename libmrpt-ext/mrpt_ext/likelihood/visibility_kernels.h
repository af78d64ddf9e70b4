#pragma once

#include <span>

#include "mrpt_ext/likelihood/prepared_detection.h"
#include "mrpt_ext/likelihood/sensor_tile.h"
#include "mrpt_ext/likelihood/visibility_limits.h"

/// Sums over landmarks at the rim of view, for all robots of a tile.
namespace mrpt_ext
{
/// A landmark of the map, from the origin of the batch.
struct ViewedLandmark
{
  float x, y;                ///< [m]
  float rise2;               ///< [m^2] squared height above the sensor
  float clutter = 0;         ///< probability that a detection of it is false
  float base = 0, gain = 0;  ///< probability of what was reported of it = base + gain * visibility
};

[[nodiscard]] ViewedLandmark viewedLandmark(const Landmark& landmark, const ScoringFrame& frame, double clutter = 0);

/// visibility += sum of the visibilities c, clutter += sum of c times the landmark's clutter.
void addVisibility(const SensorTile& tile, std::span<const ViewedLandmark> landmarks, const VisibilityLimits& limits,
                   SensorTile::Column& visibility, SensorTile::Column& clutter);

/// mean += sum of p, variance += sum of p (1 - p) with p = detection_probability c.
void addCountMoments(const SensorTile& tile, std::span<const ViewedLandmark> landmarks, const VisibilityLimits& limits,
                     float detection_probability, SensorTile::Column& mean, SensorTile::Column& variance);

/// log_sum += sum of ln(base + gain c).
void addLogReports(const SensorTile& tile, std::span<const ViewedLandmark> landmarks, const VisibilityLimits& limits,
                   SensorTile::Column& log_sum);
}  // namespace mrpt_ext
