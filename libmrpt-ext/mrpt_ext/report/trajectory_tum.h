#pragma once

#include <filesystem>

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext
{
/// Writes trajectory_<method>.tum into `folder`, also when it is empty; of several estimates with one stamp the last,
/// since TUM stamps must ascend.
void writeTrajectoryTum(const std::filesystem::path& folder, const MethodTrajectory& trajectory);
}  // namespace mrpt_ext
