#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// A pose at a time; `heading_known` is false where only the position is known.
struct TimedPose
{
  double time = 0;  ///< [s]
  Pose2 pose;
  bool heading_known = true;
};

/// Poses ordered by time, in the map frame.
using Trajectory = std::vector<TimedPose>;

/// Pose at `time`, interpolated (heading along the shorter arc) between two poses at most `max_gap` [s] apart.
/// At the exact time of a pose no neighbour is needed. Nothing outside the trajectory or inside a longer gap.
[[nodiscard]] std::optional<TimedPose> interpolate(const Trajectory& trajectory, double time, double max_gap);
}  // namespace mrpt_ext
