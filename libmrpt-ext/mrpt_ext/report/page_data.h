#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/evaluation/errors_by_geometry.h"
#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Everything that the scripts of a trial's page draw, as JSON that may stand in a script element (no "<"). `record`
/// with aligned odometry. Times in seconds since the start of the log. See chart_data.h and playback_json.h.
[[nodiscard]] std::string pageData(const RunContext& context, const RunRecord& record, const RunScore& score,
                                   const std::vector<ErrorsByGeometry>& geometry);

/// The same of a page over several trials, which has no playback.
[[nodiscard]] std::string mergedPageData(const RunScore& merged);
}  // namespace mrpt_ext
