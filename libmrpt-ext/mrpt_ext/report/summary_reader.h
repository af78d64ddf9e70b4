#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Beginning of the verdict_reason of an interrupted trial.
inline constexpr const char* kInterruptedReason = "interrupted";

/// The score in a summary.json of schema 1, of its first trial. Throws nlohmann::json::exception where a key is
/// missing.
[[nodiscard]] RunScore runScoreOf(const nlohmann::ordered_json& summary);

/// The score of trial number `trial` from the summary.json in its folder: all that a merged score needs. What is not in
/// the file stays empty: single errors, `continuous` and the judged method, which the caller knows. Nothing without the
/// file, or when it is damaged or of an interrupted trial, another trial, another random seed or other
/// inputs (log, map, truth, settings) than those of `context`.
[[nodiscard]] std::optional<RunScore> readTrialScore(const std::filesystem::path& folder, const RunContext& context,
                                                     int trial);
}  // namespace mrpt_ext
