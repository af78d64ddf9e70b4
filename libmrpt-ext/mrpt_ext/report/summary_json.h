#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// The SHA-256 of everything that determines the results of a trial, besides its random seed: the object `inputs` of a
/// summary. Null for a file that the run has not.
[[nodiscard]] nlohmann::ordered_json inputDigests(const RunContext& context);

/// Text of summary.json, schema 1: keys in the order of the contract, `null` for numbers that do not exist.
/// The same score gives the same bytes.
[[nodiscard]] std::string summaryJson(const RunContext& context, const RunScore& score);
}  // namespace mrpt_ext
