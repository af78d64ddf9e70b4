#pragma once

#include <vector>

#include "mrpt_ext/simulation/path_plan.h"
#include "mrpt_ext/simulation/robot_path.h"

namespace mrpt_ext
{
struct PlannedRoute
{
  Pose2 start;
  std::vector<TwistSegment> segments;
};

/// Straight legs from waypoint to waypoint, one run along those of the plan. With rounded corners a closed route begins
/// and ends in the middle of its first leg. Throws InputError (configuration) when there are less than two waypoints,
/// two neighbours coincide, or a rounded corner does not fit between its neighbours (it uses at most half of a leg).
[[nodiscard]] PlannedRoute followWaypoints(const PathPlan& plan);
}  // namespace mrpt_ext
