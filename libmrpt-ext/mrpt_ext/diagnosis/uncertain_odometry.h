#pragma once

#include <vector>

#include "mrpt_ext/evaluation/adopted_calibration.h"
#include "mrpt_ext/experiment/localization_input.h"

namespace mrpt_ext
{
/// A configuration for a log whose odometry may err more than its noise says: the delay that bearings tell without a
/// map (delay_without_map.h), where it differs from none by three deviations, and the scales and the veer of odometry
/// as states of the filters, as uncertain as those of a robot that nobody has calibrated.
///
/// Identities hold a pose whatever odometry does. With anonymous detections alone, a robot that comes elsewhere than
/// odometry says fits another place better, and a calibration along that place finds nothing. So this is for those;
/// nothing where the configuration has such states or no room for them, where detections are identified, and without
/// odometry or bearings.
[[nodiscard]] std::vector<CalibratedValue> uncertainOdometry(const LocalizationInput& input);
}  // namespace mrpt_ext
