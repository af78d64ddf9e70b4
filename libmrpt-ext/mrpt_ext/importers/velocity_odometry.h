#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/geometry/arc_motion.h"
#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// A commanded or measured velocity of the robot, body frame.
struct VelocityRecord
{
  double time = 0;     ///< [s]
  double forward = 0;  ///< [m/s]
  double angular = 0;  ///< [rad/s], CCW positive
};

/// Dead-reckoned poses at the stamps of `velocities` (ordered by time), starting at the origin; the velocity of a
/// record holds until the next record, so the last one moves nothing. Of records with one stamp only the last holds,
/// and they make one pose.
[[nodiscard]] std::vector<OdometryRecord> integrateVelocities(const std::vector<VelocityRecord>& velocities);
}  // namespace mrpt_ext
