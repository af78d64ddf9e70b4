#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/report/finished_runs.h"

namespace mrpt_ext
{
/// A row per run and method: name of the log, trials, successes, lost trials, seconds to converge, RMSE, median and 95
/// % of the position error [m], RMSE of the heading [deg], of the particle filter the share of the time that it was
/// `ok` and of these estimates the share whose truth lies in the stated 95 % region, each the median over the trials;
/// `-` (CSV: empty) where there is none. Methods without a position error are left out.
[[nodiscard]] std::string studyMarkdown(const std::vector<FinishedRun>& runs);
/// The same as CSV, with the settings in which the runs differ as further columns.
[[nodiscard]] std::string studyCsv(const std::vector<FinishedRun>& runs);
}  // namespace mrpt_ext
