#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Text of summary.json, schema 1: keys in the order of the contract, `null` for numbers that do not exist.
/// The same score gives the same bytes.
[[nodiscard]] std::string summaryJson(const RunContext& context, const RunScore& score);
}  // namespace mrpt_ext
