#pragma once

#include <filesystem>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// Standard deviation given to the bearings: within one position they scatter by 1.2 deg, but single channels are off
/// by up to 8 deg; about the heading that fits a row best they scatter by 2.0 deg over six positions.
inline constexpr double kRohStdBearing = degToRad(2.0);  ///< [rad]
inline constexpr const char* kRohSensor = "detector";
inline constexpr const char* kRohCategory = "beacon";

/// H. C. Roh's bearing-only readings (KAIST master's thesis, 2010; Roh, Ryu, Chung: KRoC 2010) to the landmarks 1, 2,
/// ... of landmark.csv (rows `x, y` [m]). A file `(Xx,Yy).csv` is one standstill at that position, each row a turn of
/// the detector with one bearing [deg, CCW] per landmark. Every row becomes a Reading of its own, stamped 1, 2, ...
/// seconds, files in order of x, then y. Truth is the position; the robot's heading was set only loosely and is not
/// known. Throws InputError (data) on a missing or damaged file.
[[nodiscard]] Recording importRoh(const std::filesystem::path& folder);
}  // namespace mrpt_ext
