#pragma once

#include <filesystem>

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext
{
/// The poses of a track; of several estimates with one stamp the last, since TUM stamps must ascend.
[[nodiscard]] Trajectory trajectoryOf(const MethodTrack& track);

/// Writes trajectory_<method>.tum into `folder`, also when it is empty.
void writeTrajectoryTum(const std::filesystem::path& folder, const MethodTrack& track);
}  // namespace mrpt_ext
