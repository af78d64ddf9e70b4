#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
using NumberByMethod = std::map<std::string, OptionalNumber>;

/// One finished trial, read from its summary.json.
struct FinishedTrial
{
  TrialScore score;
  NumberByMethod position_rmse_m, position_median_m, position_p95_m, heading_rmse_deg;
  NumberByMethod ok_share, coverage_95;  ///< of the particle filter alone: share of the time, see FilterScore
};

/// All trials of one configuration on one log, from one or more folders.
struct FinishedRun
{
  std::string name;  ///< of the configuration, made unique
  std::string rawlog_path, rawlog_sha256, version;
  std::vector<std::string> folders, methods;
  std::vector<FinishedTrial> trials;
  std::map<std::string, std::string> settings;  ///< Section.key of the resolved configuration, without the seed
  std::size_t repeated = 0;                     ///< duplicates by seed and number of the trial, left out
};

/// Reads the output folders of runs, with their trial_NNN where they have them. Folders with the same log and the same
/// configuration (but for seed and number of trials) are one run. Throws InputError (data) for a folder without a
/// complete summary.json.
[[nodiscard]] std::vector<FinishedRun> readFinishedRuns(const std::vector<std::filesystem::path>& folders);

/// A number of one method, of the trials that have it.
[[nodiscard]] std::vector<double> valuesOf(const FinishedRun& run, const std::string& method,
                                           NumberByMethod FinishedTrial::*number);
/// [s] of the trials that converged.
[[nodiscard]] std::vector<double> convergenceTimes(const FinishedRun& run);
}  // namespace mrpt_ext
