#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Everything that the scripts of a trial's page draw, as JSON that may stand in a script element (no "<"). `record`
/// with aligned odometry. Times in seconds since the start of the log. See playbackJson() for `playback`.
[[nodiscard]] std::string pageData(const RunContext& context, const RunRecord& record, const RunScore& score);
}  // namespace mrpt_ext
