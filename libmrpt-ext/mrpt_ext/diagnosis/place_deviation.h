#pragma once

#include <vector>

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/diagnosis/calibration_report.h"

namespace mrpt_ext
{
/// True for a line of `set` that moves a sensor on the robot: lever_arm_x_m or lever_arm_y_m.
[[nodiscard]] bool isOfLeverArm(const CalibrationFinding& finding);

/// How well the places of sensors on the robot were stated which lines of `set` correct: lever_arm_std_m and
/// yaw_std_deg, by section. Turns tell a sensor from the point that odometry follows, and bearings its axes from those
/// of odometry, and neither which of the two is where the robot's are. At most the assumed deviations, 5 cm and 5
/// degrees: a sensor that is far from where it was said to be was rather not stated at all, than that odometry follows
/// a point or an axis that far from the robot's. Nothing where it is configured.
[[nodiscard]] std::vector<CalibrationFinding> placeDeviations(const std::vector<CalibrationFinding>& set,
                                                              const CalibrationData& data,
                                                              const SensorConfigs& sensors);
}  // namespace mrpt_ext
