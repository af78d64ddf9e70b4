#pragma once

#include "mrpt_ext/calibration/self_calibration.h"
#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/diagnosis/calibration_data.h"
#include "mrpt_ext/diagnosis/calibration_finding.h"

namespace mrpt_ext
{
/// One of the `errors` that were found on top of the configured corrections, as the value of the configuration that
/// takes it up; of a sensor or of odometry, not of a landmark. Its line has no value yet.
[[nodiscard]] CalibrationFinding findingOf(const ParameterEstimate& error, const CalibrationResult& errors,
                                           const CalibrationData& data, const LocalizationConfig& config);
}  // namespace mrpt_ext
