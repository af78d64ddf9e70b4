#pragma once

#include <filesystem>
#include <string>

#include "mrpt_ext/geometry/trajectory.h"

namespace mrpt_ext
{
/// Reads a trajectory in TUM form: `timestamp tx ty tz qx qy qz qw` [s, m], `#` comments, white space between fields.
/// The heading is the yaw of the quaternion; `0 0 0 0` means that no heading is known. Times must strictly ascend.
/// Throws InputError (data) on anything else.
[[nodiscard]] Trajectory readTum(const std::filesystem::path& path);

/// Writes TUM rows (single spaces, no trailing space, no header): times and coordinates with 6 decimals, the
/// quaternion with 9 (heading exact to 2e-9 rad).
void writeTum(const std::filesystem::path& path, const Trajectory& trajectory);
/// One of these rows, with the end of the line.
[[nodiscard]] std::string tumRow(const TimedPose& entry);
}  // namespace mrpt_ext
