#pragma once

#include <filesystem>
#include <vector>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// MRPT's demo of landmark SLAM (its kf-slam_demo.rawlog, and what MRPT's simul-landmarks makes): a log of actions and
/// sensory frames with ranges and bearings, beside it <name>_ground_truth.txt, rows `x y z . . . id` [m], and perhaps
/// <name>_ground_truth_robot_path.txt, rows `x y z yaw pitch roll` [m, rad], the pose at each sensory frame. `inputs`:
/// the log, or also the other two.
/// Throws InputError (data) on missing or damaged files, and when the path has another number of poses than the log has
/// sensory frames.
[[nodiscard]] Recording importKfSlamDemo(const std::vector<std::filesystem::path>& inputs);

/// MRPT's demo of range-only SLAM (its RO-SLAM_demo.rawlog): the same with ranges alone, rows `id x y z ...` [m] in
/// <name>_ground_truth.txt, and no path. `inputs`: the log, or also the beacons.
[[nodiscard]] Recording importRoSlamDemo(const std::vector<std::filesystem::path>& inputs);
}  // namespace mrpt_ext
