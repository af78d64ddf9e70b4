#pragma once

#include <vector>

#include "mrpt_ext/diagnosis/calibration_report.h"

namespace mrpt_ext
{
/// Noise where it differs when the configuration states less: of the measurements; the share of outliers by sensor,
/// counting the detections that no landmark is near; of odometry, that of the configuration times the scatter found.
[[nodiscard]] std::vector<CalibrationFinding> noiseFindings(const CalibrationResult& errors,
                                                            const CalibrationData& data,
                                                            const LocalizationConfig& config);
}  // namespace mrpt_ext
