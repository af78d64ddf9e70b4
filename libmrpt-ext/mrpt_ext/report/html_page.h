#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// report.html of one trial: a self-contained page without scripts and without any address outside of it.
/// `record` with aligned odometry.
[[nodiscard]] std::string trialPage(const RunContext& context, const RunRecord& record, const RunScore& score);

/// report.html over several trials: outcome, merged figures, one row per trial linking to the trial's own page.
[[nodiscard]] std::string mergedPage(const RunContext& context, const RunScore& merged);
}  // namespace mrpt_ext
