#pragma once

#include <vector>

#include "mrpt_ext/simulation/robot_path.h"

namespace mrpt_ext
{
/// Straight legs from waypoint to waypoint.
struct WaypointRoute
{
  std::vector<Vector2d> waypoints;  ///< [m]
  bool closed = true;               ///< one round, back to its begin
  double turn_radius = 0;           ///< [m] of the rounded corners; 0: turns in place
  double speed = 0.3;               ///< [m/s]
  double turn_rate = 1;             ///< [rad/s] of turns in place
};

struct PlannedRoute
{
  Pose2 start;
  std::vector<TwistSegment> segments;
};

/// One run along the route. With rounded corners a closed route begins and ends in the middle of its first leg.
/// Throws InputError (configuration) when there are less than two waypoints, two neighbours coincide, or a rounded
/// corner does not fit between its neighbours (it uses at most half of a leg).
[[nodiscard]] PlannedRoute followWaypoints(const WaypointRoute& route);
}  // namespace mrpt_ext
