#pragma once

#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/geometry/odometry_path.h"
#include "mrpt_ext/geometry/scan_sweep.h"

namespace mrpt_ext
{
/// Moves every detection of a spinning scanner from the time of its beam to the stamp of the scan (Reading::time), by
/// the motion that odometry measured in between: as if the whole scan had been taken at the stamp. Bearings without a
/// range are corrected for the turn alone, because the distance is unknown: a drive of s during the scan leaves up to
/// s / distance. Ranges are moved as in the plane. Ranges without a bearing stay: when they were taken is unknown.
void removeScanSkew(Reading& reading, const ScanSweep& sweep, const OdometryPath& odometry);
}  // namespace mrpt_ext
