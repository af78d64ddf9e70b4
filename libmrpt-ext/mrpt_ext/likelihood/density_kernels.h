#pragma once

#include <span>

#include "mrpt_ext/likelihood/prepared_detection.h"
#include "mrpt_ext/likelihood/sensor_tile.h"
#include "mrpt_ext/likelihood/visibility_limits.h"

/// Densities of detections for all robots of a tile, in single precision: 1e-6 relative per detection, plus the
/// rounding of positions (1e-7 of their distance from the origin) and of headings (2e-7 rad).
namespace mrpt_ext
{
/// log_sum += sum over the sightings of ln(gauss 2^x + floor), x the Gaussian's exponent. For sharp sightings of this
/// kind. Logarithms are taken of products of up to `together` of them, see mayGoTogether().
void addLogMixtures(const SensorTile& tile, std::span<const PreparedDetection> sightings, DetectionKind kind,
                    int together, SensorTile::Column& log_sum);

/// How many mixtures between `floor` and 2 have a product that is a normal number in single precision: 8, 4 or 1.
[[nodiscard]] constexpr int mayGoTogether(float floor) { return floor > 3e-5F ? 8 : floor > 1e-9F ? 4 : 1; }

/// log_sum += sum of the Gaussians' exponents, as if there were no clutter. For sharp sightings of this kind.
void addLogGaussians(const SensorTile& tile, std::span<const PreparedDetection> sightings, DetectionKind kind,
                     SensorTile::Column& log_sum);

/// sum += sum over the sightings of gauss 2^x. For sharp sightings of this kind.
void addDensities(const SensorTile& tile, std::span<const PreparedDetection> sightings, DetectionKind kind,
                  SensorTile::Column& sum);

/// The same for any noise: the landmark's position, the sensor's carried by odometry (`carried`: covariance in sensor
/// axes) and bearings of any width count. With limits, each is weighted by the chance that the landmark is reported.
void addBroadDensities(const SensorTile& tile, std::span<const PreparedDetection> sightings, DetectionKind kind,
                       const Matrix2d& carried, const ViewLimits& limits, SensorTile::Column& sum);

/// log_sum += ln(density + floor)
void addLogOfSum(const SensorTile::Column& density, float floor, SensorTile::Column& log_sum);
}  // namespace mrpt_ext
