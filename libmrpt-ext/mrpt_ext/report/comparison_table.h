#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Console text: outcome, a table with one row per method, verdict with its reason. Plain ASCII, at most 100 columns
/// for the contract's method names. `*` marks the lowest position RMSE, `o` the oracles.
/// With several trials the numbers are medians, and the outcome gives success rate, lost runs and range.
[[nodiscard]] std::string comparisonTable(const RunScore& score);
}  // namespace mrpt_ext
