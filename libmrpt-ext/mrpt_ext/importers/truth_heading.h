#pragma once

#include <optional>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// Direction of motion relative to the heading, averaged over a trajectory.
struct DrivingDirection
{
  double angle = 0;          ///< [rad], 0 when the robot drives forward
  double concentration = 0;  ///< mean resultant length in [0, 1]; 1: always the same direction
  std::size_t segments = 0;  ///< stretches it was averaged over
};

/// Nothing when the trajectory has too few nearly straight stretches of 0.1 m and more.
[[nodiscard]] std::optional<DrivingDirection> drivingDirection(const Trajectory& trajectory);

/// Constant angle to add to the truth's heading [rad] so that the robot moves in the truth as it does in the odometry
/// (without odometry: forward). Nothing when there is no constant offset, or none beyond 5 degrees.
[[nodiscard]] std::optional<double> truthHeadingOffset(const Recording& recording);

/// Adds truthHeadingOffset() to the truth and writes a warning into the notes; does nothing when there is none.
void correctTruthHeading(Recording& recording);
}  // namespace mrpt_ext
