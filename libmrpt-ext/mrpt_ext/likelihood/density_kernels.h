#pragma once

#include <span>

#include "mrpt_ext/likelihood/prepared_detection.h"
#include "mrpt_ext/likelihood/sensor_tile.h"
#include "mrpt_ext/likelihood/visibility_limits.h"

/// Densities of detections for all robots of a tile, in single precision: 1e-6 relative per detection, plus the
/// rounding of positions (1e-7 of their distance from the origin) and of headings (2e-7 rad).
namespace mrpt_ext
{
/// log_sum += sum over the detections of ln(peak 2^x + floor), x the Gaussian's exponent. For sharp detections of this
/// kind. Logarithms are taken of products of up to `together` of them, see factorsPerLogarithm().
void addLogMixtures(const SensorTile& tile, std::span<const PreparedDetection> detections, DetectionKind kind,
                    int together, SensorTile::Column& log_sum);

/// How many factors between `floor` and 2 have a product that is a normal number in single precision: 8, 4 or 1.
[[nodiscard]] constexpr int factorsPerLogarithm(float floor) { return floor > 3e-5F ? 8 : floor > 1e-9F ? 4 : 1; }

/// sum += sum over the detections of peak 2^x. For sharp detections of this kind.
void addDensities(const SensorTile& tile, std::span<const PreparedDetection> detections, DetectionKind kind,
                  SensorTile::Column& sum);

/// The same for any noise: that of the landmark's position, that of the sensor's (`sensor_covariance`, sensor axes),
/// and bearings of any width. With limits, each density is weighted by the visibility of the landmark.
void addBroadDensities(const SensorTile& tile, std::span<const PreparedDetection> detections, DetectionKind kind,
                       const Matrix2d& sensor_covariance, const VisibilityLimits& limits, SensorTile::Column& sum);

/// log_sum += ln(density + floor)
void addLogOfSum(const SensorTile::Column& density, float floor, SensorTile::Column& log_sum);
}  // namespace mrpt_ext
