#pragma once

#include <filesystem>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
inline constexpr const char* kPlazaSensor = "radio";
inline constexpr const char* kPlazaCategory = "beacon";
/// Standard deviation given to the ranges [m]: their scatter about their mean error. That mean is not zero and grows
/// with the distance: let the estimator estimate a scale and an offset.
inline constexpr double kPlazaStdRange = 1.15;
inline constexpr double kPlazaMostRange = 500;  ///< [m], several times what the radios reach

/// CMU's ranging radios on a lawn mower (Djugash, Hamner, Roth: Navigating with Ranging Radios, J. Field Robotics
/// 26(9), 2009). `input`: a folder with <run>_TD.txt (`time, antenna, beacon, range`), <run>_DR.txt (`time, distance,
/// turn` since the row before), <run>_TL.txt (`beacon, x, y`) and perhaps <run>_GT.txt (`time, x, y, heading`); or
/// FOLDER/RUN. [s, m, rad] Odometry: every row an arc. Readings: planar ranges, one per row; rows that go back in time
/// are sorted in and named in a warning. Throws InputError, see run_files.h; data for a missing or damaged file.
[[nodiscard]] Recording importPlaza(const std::filesystem::path& input);
}  // namespace mrpt_ext
