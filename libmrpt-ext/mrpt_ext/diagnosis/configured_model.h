#pragma once

#include "mrpt_ext/calibration/predictive_likelihood.h"
#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/diagnosis/calibration_data.h"

namespace mrpt_ext
{
/// What the configuration assumes of a recording: its errors in the order of `unknowns`, most of them none.
[[nodiscard]] RecordingModel configuredModel(const CalibrationData& data,
                                             const std::vector<CalibrationUnknown>& unknowns,
                                             const LocalizationConfig& config);

/// True for an error that is assumed to be zero.
[[nodiscard]] bool isNone(const AssumedError& error);
}  // namespace mrpt_ext
