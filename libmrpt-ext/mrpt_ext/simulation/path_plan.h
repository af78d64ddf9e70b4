#pragma once

#include <vector>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
enum class PathKind
{
  standstill,
  waypoints,
  circle,
  square,      ///< waypoints at the corners of a square
  random_walk  ///< random turns inside a box
};

/// How a robot (or a moving object) drives.
struct PathPlan
{
  PathKind kind = PathKind::waypoints;
  Pose2 start;                        ///< of standstill and random_walk
  double speed = 0.3;                 ///< [m/s]
  double turn_rate = degToRad(60.0);  ///< [rad/s] of turns in place; the largest one of a random walk

  std::vector<Vector2d> waypoints;  ///< [m]
  bool closed = true;               ///< from the last waypoint to the first and round again; otherwise it ends there
  double turn_radius = 0;           ///< [m] of rounded corners of waypoints and square; 0: turns in place

  Vector2d centre{0, 0};   ///< [m] of circle and square
  double radius = 1;       ///< [m] of the circle
  double side = 1;         ///< [m] of the square
  bool clockwise = false;  ///< circle and square

  Vector2d low{0, 0}, high{0, 0};  ///< [m] box that a random walk does not leave
  double straight_share = 0;       ///< of the arcs of a random walk that are straight lines
  double rest_share = 0;           ///< ... and rests
};
}  // namespace mrpt_ext
