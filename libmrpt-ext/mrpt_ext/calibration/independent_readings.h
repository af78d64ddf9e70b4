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

/// The first of the spacings 0, 0.1, 0.2, 0.4 ... 12.8 s at which the autocorrelation of successive misfits of one
/// landmark is below 1/e, or not told by 20 pairs; the last one where there is none. Of each sensor and kind that has
/// readings. `misfits`: of each reading, as of an adjustment; beyond that of an outlier they count as that.
[[nodiscard]] CorrelationTimes correlationTimes(const CalibrationProblem& problem, const std::vector<double>& misfits);

/// For each reading: true unless one of the same landmark, sensor and kind is kept that was less than the correlation
/// time before it, by more than the jitter of stamps (0.01 s).
[[nodiscard]] std::vector<bool> independentReadings(const CalibrationProblem& problem, const CorrelationTimes& times);
}  // namespace mrpt_ext
