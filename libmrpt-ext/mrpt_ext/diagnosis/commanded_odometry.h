#pragma once

#include <vector>

#include "mrpt_ext/geometry/odometry_path.h"

namespace mrpt_ext
{
/// True for odometry that is integrated from commands: its velocities mostly stay the same from record to
/// record, and then jump. What wheels measure scatters and takes time to change. A robot follows commands late, so a
/// delay between such odometry and a sensor is odometry's.
[[nodiscard]] bool isCommanded(const std::vector<OdometryRecord>& odometry);
}  // namespace mrpt_ext
