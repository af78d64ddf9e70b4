#pragma once

#include <map>
#include <utility>
#include <vector>

#include "mrpt_ext/calibration/calibration_problem.h"

namespace mrpt_ext
{
/// How far apart two readings of one landmark must be for their errors to be independent, by number of the sensor and
/// whether they are ranges [s].
using CorrelationTimes = std::map<std::pair<std::size_t, bool>, double>;

/// The least spacing, of none and 0.1 s times powers of two, at which successive misfits of one landmark have an
/// autocorrelation below 1/e. `misfits`: of each reading, as of an adjustment; what exceeds an outlier's counts as one.
[[nodiscard]] CorrelationTimes correlationTimes(const CalibrationProblem& problem, const std::vector<double>& misfits);

/// For each reading: true unless one of the same landmark, sensor and kind is kept that was less than the correlation
/// time before it.
[[nodiscard]] std::vector<bool> independentReadings(const CalibrationProblem& problem, const CorrelationTimes& times);
}  // namespace mrpt_ext
