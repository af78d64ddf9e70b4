#pragma once

#include <vector>

#include "mrpt_ext/diagnosis/calibration_report.h"

namespace mrpt_ext
{
/// True where all readings of the kind have one declared deviation: a factor on it is a value of the configuration.
[[nodiscard]] bool areDeclaredAlike(const CalibrationProblem& problem, std::size_t sensor, bool is_range);

/// Noise, which differs when the configuration states less by more than three standard deviations: of the measurements;
/// the share of outliers by sensor, counting the detections that no landmark is near; of odometry, that of the
/// configuration times the scatter found.
[[nodiscard]] std::vector<CalibrationFinding> noiseFindings(const CalibrationResult& errors,
                                                            const CalibrationData& data,
                                                            const LocalizationConfig& config);
}  // namespace mrpt_ext
