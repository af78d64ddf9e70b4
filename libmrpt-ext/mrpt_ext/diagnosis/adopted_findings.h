#pragma once

#include <vector>

#include "mrpt_ext/diagnosis/calibration_choice.h"
#include "mrpt_ext/diagnosis/calibration_report.h"

namespace mrpt_ext
{
/// The values of the configuration that `choice` adopts, estimated from the whole recording with the other errors held
/// as configured. Empty when the whole recording does not determine them.
[[nodiscard]] std::vector<CalibrationFinding> adoptedFindings(const CalibrationChoice& choice,
                                                              const CalibrationData& data,
                                                              const LocalizationConfig& config);

/// Offsets of the bearings, estimated beside what `choice` adopts, where they differ from the configured ones: nobody
/// but the user can tell them from axes of the robot that are turned. `unknowns`: all that the recording could tell.
[[nodiscard]] std::vector<CalibrationFinding> bearingOffsetFindings(const CalibrationChoice& choice,
                                                                    const CalibrationData& data,
                                                                    const std::vector<CalibrationUnknown>& unknowns,
                                                                    const LocalizationConfig& config);
}  // namespace mrpt_ext
