#pragma once

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/simulation/path_plan.h"
#include "mrpt_ext/simulation/robot_path.h"

namespace mrpt_ext
{
/// The path over `duration` [s], repeated where the plan says so. A closed path with rounded corners starts in the
/// middle of its first leg, every other at its first waypoint. Throws InputError (configuration) when corners do not
/// fit between the waypoints, a leg has no length, or a random walk starts outside its box.
[[nodiscard]] RobotPath planPath(const PathPlan& plan, double duration, RandomStream& random);
}  // namespace mrpt_ext
