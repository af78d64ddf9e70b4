#pragma once

#include <string>

#include "mrpt_ext/report/finished_runs.h"

namespace mrpt_ext
{
/// Page that compares runs: success rates with their uncertainty, and the errors of all methods in each run.
[[nodiscard]] std::string comparisonPage(const std::vector<FinishedRun>& runs);

/// 95 % score interval of the success probability after `successes` in `trials` (Wilson, JASA 22, 1927). {0, 1} without
/// trials.
[[nodiscard]] std::pair<double, double> successInterval(std::size_t successes, std::size_t trials);
}  // namespace mrpt_ext
