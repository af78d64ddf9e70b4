#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// HTML for a reader who asks what is wrong.

/// When hypotheses were injected, how often, and why; injections that follow each other closely are one row. Empty
/// without any.
[[nodiscard]] std::string reseedingTable(const RunRecord& record, const RunContext& context);

/// What to do about `ambiguous`, `lost` and injected hypotheses, as far as the run has them.
[[nodiscard]] std::string adviceList(const RunScore& score);
}  // namespace mrpt_ext
