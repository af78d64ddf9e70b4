#pragma once

#include "mrpt_ext/geometry/vector_math.h"
#include "mrpt_ext/likelihood/prepared_detection.h"
#include "mrpt_ext/likelihood/sensor_tile.h"
#include "mrpt_ext/likelihood/visibility_limits.h"

/// Geometry of one landmark seen by one robot of a tile; inlined into vector loops.
namespace mrpt_ext::tile_geometry
{
constexpr float kMinDistance2 = 1e-12F;  // [m^2] a bearing to a landmark at the sensor itself has no direction

struct Offset
{
  float dx, dy, distance2;  // from the sensor to the landmark, world axes [m]
};

[[gnu::always_inline]] inline Offset offsetTo(float landmark_x, float landmark_y, float sensor_x, float sensor_y)
{
  const float dx = landmark_x - sensor_x, dy = landmark_y - sensor_y;
  return {dx, dy, dx * dx + (dy * dy + kMinDistance2)};
}

/// Squared bearing error [rad^2] of a sharp detection; (c, s): the heading that bearings refer to.
[[gnu::always_inline]] inline float sharpBearingError2(const Offset& to, float ray_x, float ray_y, float c, float s)
{
  const float x = c * to.dx + s * to.dy, y = c * to.dy - s * to.dx;  // the landmark in the sensor's axes
  const float along = ray_x * x + ray_y * y, across = ray_x * y - ray_y * x, across2 = across * across;
  const float sine2 = across2 / (across2 + along * along);
  return vector_math::squaredAngleOf(along > 0.0F ? sine2 : 1.0F);
}

/// The same [rad], exact for all angles.
[[gnu::always_inline]] inline float bearingError(const Offset& to, float ray_x, float ray_y, float c, float s)
{
  const float x = c * to.dx + s * to.dy, y = c * to.dy - s * to.dx;
  return vector_math::angleOf(ray_x * y - ray_y * x, ray_x * x + ray_y * y);
}

[[gnu::always_inline]] inline float clampedShare(float value)
{
  const float low = value > 0.0F ? value : 0.0F;
  return low < 1.0F ? low : 1.0F;
}

/// Single-precision form of VisibilityLimits.
struct TileLimits
{
  float range_offset, range_slope, bearing_offset, bearing_slope;

  explicit TileLimits(const VisibilityLimits& limits)
      : range_offset(static_cast<float>(limits.range_offset)),
        range_slope(static_cast<float>(limits.range_slope)),
        bearing_offset(static_cast<float>(limits.bearing_offset)),
        bearing_slope(static_cast<float>(limits.bearing_slope))
  {
  }
};

/// Visibility of the landmark for a sensor of true heading (c, s).
template <bool LimitsBearing>
[[gnu::always_inline]] inline float visibilityOf(const Offset& to, float rise2, float c, float s,
                                                 const TileLimits& limits)
{
  float visibility = clampedShare(limits.range_offset - limits.range_slope * std::sqrt(to.distance2 + rise2));
  if constexpr (LimitsBearing)
  {
    const float bearing = std::abs(bearingError(to, 1.0F, 0.0F, c, s));
    visibility *= clampedShare(limits.bearing_offset - limits.bearing_slope * bearing);
  }
  return visibility;
}
}  // namespace mrpt_ext::tile_geometry
