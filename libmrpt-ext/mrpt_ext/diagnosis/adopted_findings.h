#pragma once

#include <vector>

#include "mrpt_ext/diagnosis/calibration_choice.h"
#include "mrpt_ext/diagnosis/calibration_report.h"

namespace mrpt_ext
{
/// The values of the configuration that `choice` adopts, estimated from the whole recording with the other errors held
/// as configured, also those that the whole recording does not tell by two standard deviations. Empty when the whole
/// recording does not determine them. An offset of bearings is adopted as a direction of odometry's x axis where the
/// sensor is all that has axes on the robot: one sensor of bearings, all sensors at the robot's origin, no compass;
/// beyond 10 degrees the direction of the sensor was rather not stated.
[[nodiscard]] std::vector<CalibrationFinding> adoptedFindings(const CalibrationChoice& choice,
                                                              const CalibrationData& data,
                                                              const LocalizationConfig& config);
}  // namespace mrpt_ext
