#pragma once

#include <vector>

#include "mrpt_ext/geometry/random.h"
#include "mrpt_ext/simulation/robot_path.h"

namespace mrpt_ext
{
/// Straight rows of posts that are no landmarks, look like them, and hide what is behind them: fences, chairs, robots
/// that wait. Where detections are anonymous they agree with each other from frame to frame, but with no landmark.
struct BarrierPlan
{
  int count = 0;
  double length = 2;         ///< [m]
  double spacing = 0.5;      ///< [m] between neighbouring posts
  double post_radius = 0.1;  ///< [m]
  double clearance = 0.4;    ///< [m] to the path of the robot, which drives through none
};

/// Positions of the posts [m], with random rows inside the box [low, high]. Throws InputError (configuration) when a
/// row finds no room.
[[nodiscard]] std::vector<Vector2d> planBarriers(const BarrierPlan& plan, const Vector2d& low, const Vector2d& high,
                                                 const RobotPath& path, RandomStream& random);
}  // namespace mrpt_ext
