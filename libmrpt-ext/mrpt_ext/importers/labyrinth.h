#pragma once

#include <filesystem>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
inline constexpr const char* kLabyrinthSensor = "uwb";
inline constexpr const char* kLabyrinthCategory = "module";
inline constexpr double kLabyrinthMostRange = 100;  ///< [m]

/// A recording in the text form of TU Chemnitz' libRSF, as its Labyrinth set (T. Pfeifer, 2017): a small robot with two
/// wheels and one ultra-wideband module that ranges to modules at known positions, one after the other.
/// `input`: a folder with <run>_Input.txt and perhaps <run>_GT.txt, or FOLDER/RUN. Rows, white space between:
///   range2 time range variance module_x module_y module 0
///   odom2diff time v_1 v_2 v_y half_axle variance_1 variance_2 variance_y
///   point2 time x y and a 2x2 covariance (GT; no heading)
/// [s, m, m/s] The set's own description calls v_1 the right wheel and half_axle the distance of the wheels; its
/// authors' library takes v_1 for the left one and the distance for half of it, which is what fits the ranges. A
/// velocity holds until the next row. Throws InputError, see run_files.h; data for a missing or damaged file.
[[nodiscard]] Recording importLabyrinth(const std::filesystem::path& input);
}  // namespace mrpt_ext
