#pragma once

#include <filesystem>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Writes the results of a trial into `folder`: summary.json, report.html, steps.csv, hypotheses.csv, objects.csv (only
/// when objects were configured or detected), trajectory_<method>.tum. Dead reckoning is aligned to the truth first,
/// where there is one, so that the files agree with the score. Each file appears complete or not at all. Throws
/// InputError (data) when a file cannot be written.
void writeTrial(const std::filesystem::path& folder, const RunContext& context, RunRecord record,
                const RunScore& score);

/// Writes summary.json and report.html over several trials; the trials are in trial_NNN (trialFolder()).
void writeMerged(const std::filesystem::path& folder, const RunContext& context, const RunScore& merged);
}  // namespace mrpt_ext
