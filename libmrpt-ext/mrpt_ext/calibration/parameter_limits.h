#pragma once

#include "mrpt_ext/calibration/calibration_problem.h"

namespace mrpt_ext
{
/// Standard deviation of an error before the recording is seen, in the unit of the parameter: that of a lever arm as
/// stated, that of a landmark's offset as the ranges' own, to begin with, that of a camera's focal length 5 % and
/// that of its axis 2.9 deg, those of others wider than such errors are, so that what the recording does not tell stays
/// finite.
[[nodiscard]] double priorStd(const CalibrationProblem& problem, const CalibrationUnknown& unknown);

/// Largest standard deviation with which an estimate is of use; it says something that was not known before.
[[nodiscard]] double largestUsefulStd(const CalibrationProblem& problem, const CalibrationUnknown& unknown);
}  // namespace mrpt_ext
