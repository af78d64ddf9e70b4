#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// report.html of one trial: one file that requests nothing from outside. Tables and a static map are readable without
/// scripts; charts and playback need them. `record` with aligned odometry.
[[nodiscard]] std::string trialPage(const RunContext& context, const RunRecord& record, const RunScore& score);

/// report.html over several trials: outcome, merged scores, one row per trial linking to the trial's own page.
[[nodiscard]] std::string mergedPage(const RunContext& context, const RunScore& merged);
}  // namespace mrpt_ext
