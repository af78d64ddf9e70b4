#pragma once

#include <vector>

#include "mrpt_ext/diagnosis/calibration_choice.h"
#include "mrpt_ext/diagnosis/calibration_report.h"

namespace mrpt_ext
{
/// The values of the configuration that `choice` adopts, estimated from the whole recording with the other errors held
/// as configured. Empty when the whole recording does not determine them. Where one sensor measures bearings, their
/// offset is adopted as a direction of odometry's x axis: the heading stays what the readings say.
[[nodiscard]] std::vector<CalibrationFinding> adoptedFindings(const CalibrationChoice& choice,
                                                              const CalibrationData& data,
                                                              const LocalizationConfig& config);
}  // namespace mrpt_ext
