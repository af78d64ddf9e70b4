#pragma once

#include <vector>

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/diagnosis/calibration_report.h"

namespace mrpt_ext
{
/// How well the places of sensors on the robot were stated which lines of `set` correct: lever_arm_std_m, by section.
/// Turns tell a sensor from the point that odometry follows, and not which of the two is where the robot's point is. At
/// most the assumed deviation: a sensor that is far from where it was said to be was rather not stated at all, than
/// that odometry follows a point that far from the robot's. Nothing where it is configured.
[[nodiscard]] std::vector<CalibrationFinding> placeDeviations(const std::vector<CalibrationFinding>& set,
                                                              const SensorConfigs& sensors);
}  // namespace mrpt_ext
