#pragma once

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/geometry/trajectory.h"

namespace mrpt_ext
{
/// True for odometry that is integrated from commands: its velocities mostly stay the same from record to
/// record, and then jump. What wheels measure scatters and takes time to change. A robot follows commands late, so a
/// delay between such odometry and a sensor is odometry's.
[[nodiscard]] bool isCommanded(const Trajectory& odometry);

/// True where the heading of odometry may drift: not that of commands, since a robot stands still when told to, unless
/// the configuration states a drift.
[[nodiscard]] bool mayDrift(bool commanded, const LocalizationConfig& config);
}  // namespace mrpt_ext
