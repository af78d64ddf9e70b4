#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/experiment/method_factory.h"

namespace mrpt_ext
{
/// Adapts the configuration to what the log contains, and adds a line to `notes` for each adaptation:
/// - Without odometry, a motion model of type `odometry` or `velocity` has nothing to work on: the motion is a random
///   walk at walking speed.
/// - Where moreover no measurement depends on the heading (ranges to the robot's origin), the heading is unobservable:
///   the filters estimate and judge the position alone.
void adaptToLog(LocalizationConfig& config, const AvailableMeasurements& available, std::vector<std::string>& notes);
}  // namespace mrpt_ext
