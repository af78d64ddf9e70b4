#pragma once

#include <array>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/bias_model.h"

namespace mrpt_ext
{
/// How files and texts write one kind of systematic error.
struct BiasUnit
{
  BiasKind kind;
  const char* name;    ///< "range_offset"
  const char* unit;    ///< "m", "deg", or empty for a ratio
  const char* suffix;  ///< of keys and columns: "_m", "_deg" or empty
  double factor;       ///< value in a file = factor * BiasState::mean
};

inline constexpr std::array<BiasUnit, 8> kBiasUnits{{
    {BiasKind::range_offset, "range_offset", "m", "_m", 1},
    {BiasKind::range_scale, "range_scale", "", "", 1},
    {BiasKind::bearing_offset, "bearing_offset", "deg", "_deg", radToDeg(1.0)},
    {BiasKind::distance_scale, "odometry_distance_scale", "", "", 1},
    {BiasKind::rotation_scale, "odometry_rotation_scale", "", "", 1},
    {BiasKind::arc_scale, "odometry_arc_scale", "", "", 1},
    {BiasKind::veer, "odometry_veer", "deg/m", "_deg_per_m", radToDeg(1.0)},
    {BiasKind::drift, "odometry_drift", "deg/s", "_deg_per_s", radToDeg(1.0)},
}};

[[nodiscard]] constexpr const BiasUnit& unitOf(BiasKind kind) { return kBiasUnits[static_cast<std::size_t>(kind)]; }
}  // namespace mrpt_ext
