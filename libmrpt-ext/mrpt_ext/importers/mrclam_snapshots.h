#pragma once

#include <filesystem>
#include <optional>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
inline constexpr std::size_t kMrclamLeastLandmarks = 3;  ///< distinct ones that a snapshot must show

/// Snapshots.csv of an MRCLAM folder: readings taken at standstill, for closed-form methods. One Reading per snapshot;
/// rows with inlier = 1 only, the rows of one landmark averaged, at least three distinct landmarks. No odometry: the
/// snapshots are independent of each other, and those of different robots overlap in time. So each one is stamped with
/// its number in the file, in seconds; truth is the file's pose at the same stamp. Standard deviations as in mrclam.h:
/// averaging lessens the scatter, but not the biases that dominate at standstill.
/// `robot`: only snapshots of that robot. Throws InputError (data) on a missing or damaged file.
[[nodiscard]] Recording importMrclamSnapshots(const std::filesystem::path& folder, std::optional<int> robot = {});
}  // namespace mrpt_ext
