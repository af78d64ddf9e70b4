#pragma once

#include <filesystem>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// MRPT's range-only demo log (action/sensory-frame form, beacon ranges with neither times nor labels), with its truth
/// file `step x y phi`: the pose at the time of each step, moved by `T_map_truth`, the pose of the truth's frame in the
/// map. With an empty `truth`, <log's name>_GT.txt beside the log is read if it exists.
/// Throws InputError (data) on missing or damaged files, and when the truth has steps beyond the end of the log.
[[nodiscard]] Recording importUwbDemo(const std::filesystem::path& rawlog, const std::filesystem::path& truth,
                                      const Pose2& T_map_truth, const LandmarkTable& beacons);
}  // namespace mrpt_ext
