#pragma once

#include <filesystem>
#include <map>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Reads MRPT's truth file of its range-only demos, rows `step x y phi` [m, rad]: the pose after action number `step`
/// of a log in action/sensory-frame form. Steps must ascend; some may be missing. `T_map_file` is the pose of the
/// file's frame in the map and is applied to every pose. The caller joins steps with the log's times.
/// Throws InputError (data) on a missing or damaged file.
[[nodiscard]] std::map<int, Pose2> readMrptIndexTruth(const std::filesystem::path& path, const Pose2& T_map_file);
}  // namespace mrpt_ext
