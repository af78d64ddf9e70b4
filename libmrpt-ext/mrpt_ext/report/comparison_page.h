#pragma once

#include <string>

#include "mrpt_ext/report/finished_runs.h"

namespace mrpt_ext
{
/// Page that compares runs: success rates with their uncertainty, and the errors of all methods, runs beside each
/// other.
[[nodiscard]] std::string comparisonPage(const std::vector<FinishedRun>& runs);

/// What success of `successes` in `trials` tells of the chance of success: the 95 % score interval (Wilson, JASA 22,
/// 1927). {0, 1} without trials.
[[nodiscard]] std::pair<double, double> successInterval(std::size_t successes, std::size_t trials);
}  // namespace mrpt_ext
