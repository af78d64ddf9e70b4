#pragma once

#include "mrpt_ext/diagnosis/calibration_data.h"

namespace mrpt_ext
{
/// Leaves out ranges of radios whose error is that of a range to the same radio shortly before, where odometry is at
/// hand: until the misfits of those that stay are hardly correlated (calibration/independent_readings.h). Radios
/// without a line of sight err alike for seconds; an adjustment that takes their errors for white follows them, and
/// finds that odometry is bad. Where bearings are measured as well a few readings tell the pose, and errors of ranges
/// from it. Of the readings that no landmark is near as large a share is left out.
void leaveOutRepeated(CalibrationData& data, const std::vector<CalibrationUnknown>& unknowns);
}  // namespace mrpt_ext
