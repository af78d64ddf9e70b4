#pragma once

#include <vector>

#include "mrpt_ext/calibration/self_calibration.h"

namespace mrpt_ext
{
/// Number of the pose in the middle of the readings.
[[nodiscard]] std::size_t middleOf(const CalibrationProblem& problem);

/// The poses up to `end`, and their readings.
[[nodiscard]] CalibrationProblem firstPart(const CalibrationProblem& problem, std::size_t end);

/// Calibration of those of the `unknowns` that `numbers` name, the others as configured: errors that are hard to tell
/// apart have other values together. By number of all unknowns; those that are not named are as in `otherwise`, which
/// is also returned when nothing can be estimated.
[[nodiscard]] CalibrationResult calibrateSome(const CalibrationProblem& problem,
                                              const std::vector<CalibrationUnknown>& unknowns,
                                              const std::vector<std::size_t>& numbers,
                                              const CalibrationResult& otherwise);

/// Numbers of the unknowns that stay where regimes of motion that `found` does not tell apart are left out: a robot
/// that only turns in place, or drives the same curve all the time, tells the scales of all motions, but beside an
/// error of that regime neither. Turns in place differ by at least `deviations` standard deviations.
[[nodiscard]] std::vector<std::size_t> withToldRegimes(const std::vector<CalibrationUnknown>& unknowns,
                                                       const CalibrationResult& found, double deviations);

/// A calibration for some unknowns less, to first order: the others take up what they have in common with the errors
/// `numbers`.
[[nodiscard]] CalibrationResult withoutErrors(CalibrationResult found, const std::vector<std::size_t>& numbers);
}  // namespace mrpt_ext
