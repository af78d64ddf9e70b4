#pragma once

#include <filesystem>
#include <optional>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// What the verdict's reason of an interrupted trial begins with.
inline constexpr const char* kInterruptedReason = "interrupted";

/// The score of trial number `trial` as the summary.json in its folder tells it: all that a merged score is made of.
/// What the file does not hold stays empty: single errors, `continuous` and the judged method, which the caller knows.
/// Nothing when there is no such file, or when it is damaged, of a trial that was interrupted, of another trial, of
/// another log or of another random seed than those of `context`.
[[nodiscard]] std::optional<RunScore> readTrialScore(const std::filesystem::path& folder, const RunContext& context,
                                                     int trial);
}  // namespace mrpt_ext
