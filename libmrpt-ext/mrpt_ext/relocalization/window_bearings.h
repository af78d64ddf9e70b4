#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mrpt_ext/relocalization/grid_search.h"
#include "mrpt_ext/relocalization/hypothesis_track.h"

namespace mrpt_ext
{
/// The bearings of the looks before and after one of a way, as seen from its pose: as far as odometry joins them better
/// than to a few degrees, and at most twenty or so. What odometry may be wrong by is part of their deviations.
[[nodiscard]] std::vector<WindowBearing> windowBearings(std::span<const TrajectoryStep> way, std::size_t at);
}  // namespace mrpt_ext
