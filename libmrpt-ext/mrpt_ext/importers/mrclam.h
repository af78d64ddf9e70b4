#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// Standard deviations given to MRCLAM's detections. Measured against the motion capture's poses of data set 6 (15 359
/// readings of landmarks): inlier bearings scatter by 0.53-1.11 deg per robot about biases of up to 0.8 deg, inlier
/// ranges by 0.08 m near and 0.19 m far, 0.155 m over all. 2.2 % are gross outliers: leave the likelihood a clutter
/// term.
inline constexpr double kMrclamStdBearing = degToRad(1.0);  ///< [rad]
inline constexpr double kMrclamStdRange = 0.155;            ///< [m]
inline constexpr const char* kMrclamSensor = "camera";
/// Label of a robot's own camera, "camera.<robot>": the five are not alike.
[[nodiscard]] std::string mrclamCamera(int robot);

/// One robot of a UTIAS MRCLAM data set (format: mrclam_files.h).
/// Odometry: commanded velocities integrated as arcs. Readings: rows of one stamp, barcodes replaced by landmark ids;
/// readings of other robots, of unknown barcodes and of landmarks without a position are dropped and counted. Truth:
/// dense if present, else sparse, else empty. A robot without an odometry file gives readings only, with a note.
/// Throws InputError: data for damaged files, configuration when the folder has no such robot.
[[nodiscard]] Recording importMrclam(const std::filesystem::path& folder, int robot);

/// Robots that have a measurement file in this folder, ascending.
[[nodiscard]] std::vector<int> mrclamRobots(const std::filesystem::path& folder);
}  // namespace mrpt_ext
