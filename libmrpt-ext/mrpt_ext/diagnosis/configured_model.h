#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/calibration/predictive_likelihood.h"
#include "mrpt_ext/configuration/localization_config.h"

namespace mrpt_ext
{
/// What the configuration assumes of a recording: its errors in the order of `unknowns`, most of them none. `sensors`:
/// labels, by number.
[[nodiscard]] RecordingModel configuredModel(const std::vector<std::string>& sensors,
                                             const std::vector<CalibrationUnknown>& unknowns,
                                             const LocalizationConfig& config);
}  // namespace mrpt_ext
