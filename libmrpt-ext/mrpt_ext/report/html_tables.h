#pragma once

#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// HTML tables of a report; a dash marks a number that does not exist.

/// All methods side by side, the best marked, oracles marked as such.
[[nodiscard]] std::string methodTable(const RunScore& score);
/// Per landmark; those with a warning highlighted. Empty without landmarks.
[[nodiscard]] std::string landmarkTable(const RunScore& score);
/// Observation classes with counts used and ignored. Empty without observations.
[[nodiscard]] std::string observationTable(const RunContext& context);
/// Particles, consistency and recovery of the filter. Empty when no filter ran.
[[nodiscard]] std::string filterTable(const RunScore& score);
/// The longest stretches without `ok`. Empty without any.
[[nodiscard]] std::string spellTable(const RunScore& score);
/// One row per trial, each linking to its own report `trial_NNN/report.html`.
[[nodiscard]] std::string trialTable(const RunScore& score);
/// What it takes to reproduce the run: command, configuration, seed, version, input.
[[nodiscard]] std::string provenanceTable(const RunContext& context, const RunScore& score);

/// Ids in the order of the table: numbers by value, then text.
[[nodiscard]] std::vector<std::string> landmarkOrder(const RunScore& score);

/// Name of the sub-folder of a trial.
[[nodiscard]] std::string trialFolder(int trial);
}  // namespace mrpt_ext
