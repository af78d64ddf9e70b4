#pragma once

#include <optional>

#include "mrpt_ext/calibration/self_calibration.h"
#include "mrpt_ext/diagnosis/calibration_data.h"

namespace mrpt_ext
{
/// Leaves out ranges whose error is that of a range to the same landmark shortly before, where there is odometry and no
/// sensor measures bearings: until the misfits of the ranges that stay are hardly correlated
/// (calibration/independent_readings.h), or hardly enough stay to estimate `unknowns` from each half of them. Radios
/// without a line of sight err alike for seconds; an adjustment that takes their errors for white follows them, and
/// finds that odometry is bad. Where bearings are measured as well a few readings tell the pose, and the pose the
/// errors of ranges. Of the ranges that no landmark is near the same share is left out. Sets `correlation_times` and
/// counts in `repeated`; nothing is done where the adjustment fails. Returns calibrate() of the readings that stay,
/// where the search ended with it.
std::optional<CalibrationResult> leaveOutRepeated(CalibrationData& data,
                                                  const std::vector<CalibrationUnknown>& unknowns);
}  // namespace mrpt_ext
