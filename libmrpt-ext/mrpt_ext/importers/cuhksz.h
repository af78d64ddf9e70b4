#pragma once

#include <array>
#include <filesystem>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
inline constexpr const char* kCuhkszCategory = "anchor";
inline constexpr double kCuhkszStdRange = 0.1;     ///< [m], about the ranges' constant error
inline constexpr double kCuhkszMostRange = 100;    ///< [m]
inline constexpr double kCuhkszBodyHeight = 0.97;  ///< [m] of the body frame above the floor of the anchors' frame

/// The anchors 0 ... 7 [m].
inline const std::array<Vector3d, 8> kCuhkszAnchors{{{-3.4203, 3.0053, 1.0442},
                                                     {0.0016, 3.0110, 1.0446},
                                                     {3.6056, 2.9795, 1.0463},
                                                     {3.6011, -0.0008, 1.0422},
                                                     {3.5674, -3.0087, 1.0443},
                                                     {-0.0072, -2.9652, 1.0444},
                                                     {-3.4673, -2.9587, 1.0445},
                                                     {-3.4858, -0.0098, 1.0457}}};
/// The tags 0 ... 2 in the body frame [m].
inline const std::array<Vector3d, 3> kCuhkszTags{
    {{-0.0689, -0.1423, 0.0011}, {-0.0750, 0.1402, 0.0016}, {0.2034, 0.1451, -0.0008}}};

/// CUHK-Shenzhen's trolley with three ultra-wideband tags among eight anchors, planar set (H. Jiang, 2023). `input`: a
/// folder with UWB_<run>.csv (rows: local date and time, then the ranges [m] a0-t0, a0-t1, a0-t2, a1-t0, ... a7-t2,
/// empty where there is none) and perhaps motion_capture_<run>.csv (header line, then date and time, x, y, z, qw, qx,
/// qy, qz), plain or .gz; or FOLDER/RUN. Sensors tag0, tag1, tag2: one reading each per row. No odometry. Truth: the
/// motion capture's body, whose z axis points down: its heading is where its x axis points. Throws InputError, see
/// run_files.h; data for a missing or damaged file.
[[nodiscard]] Recording importCuhksz(const std::filesystem::path& input);
}  // namespace mrpt_ext
