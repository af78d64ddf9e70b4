#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mrpt_ext/relocalization/grid_search.h"
#include "mrpt_ext/relocalization/hypothesis_track.h"

namespace mrpt_ext
{
/// The bearings around one step of a trajectory, relative to the robot pose at that step: of the step itself and of
/// those before and after it, as long as the odometry in between is accurate to a few degrees, about twenty at most.
/// The odometry covariance is part of their standard deviations.
[[nodiscard]] std::vector<WindowBearing> windowBearings(std::span<const TrajectoryStep> trajectory, std::size_t step);
}  // namespace mrpt_ext
