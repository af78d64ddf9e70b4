#include "mrpt_ext/simulation/path_planner.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/simulation/waypoint_route.h"

namespace mrpt_ext
{
namespace
{
/// Repeats one round until `duration` is covered.
std::vector<TwistSegment> repeated(const std::vector<TwistSegment>& round, double duration)
{
  double round_time = 0;
  for (const TwistSegment& segment : round) round_time += segment.duration;
  std::vector<TwistSegment> segments = round;
  if (round_time > 0)
    for (double covered = round_time; covered < duration; covered += round_time)
      segments.insert(segments.end(), round.begin(), round.end());
  return segments;
}

RobotPath planCircle(const PathPlan& plan, double duration)
{
  const double sense = plan.clockwise ? -1 : 1;
  const Pose2 start{plan.centre.x() + plan.radius, plan.centre.y(), sense * kPi / 2};
  return RobotPath(start, {{duration, plan.speed, sense * plan.speed / plan.radius}});
}

std::vector<Vector2d> squareCorners(const PathPlan& plan)
{
  const double h = 0.5 * plan.side;
  std::vector<Vector2d> corners{{-h, -h}, {h, -h}, {h, h}, {-h, h}};
  if (plan.clockwise) std::reverse(corners.begin(), corners.end());
  for (Vector2d& corner : corners) corner += plan.centre;
  return corners;
}

RobotPath planRoute(PathPlan plan, double duration)
{
  if (plan.kind == PathKind::square)
  {
    plan.waypoints = squareCorners(plan);
    plan.closed = true;
  }
  const PlannedRoute planned = followWaypoints(plan);
  return RobotPath(planned.start, plan.closed ? repeated(planned.segments, duration) : planned.segments);
}

bool inside(const PathPlan& plan, const Pose2& pose)
{
  return pose.x >= plan.low.x() && pose.x <= plan.high.x() && pose.y >= plan.low.y() && pose.y <= plan.high.y();
}

/// Arcs of half a second to two seconds with random turn rates; an arc that would leave the box is replaced by a turn
/// in place towards the middle of the box, give or take 60 degrees.
RobotPath planRandomWalk(const PathPlan& plan, double duration, RandomStream& random)
{
  if (!inside(plan, plan.start)) throw configurationError("path: a random walk must start inside its bounds");
  std::vector<TwistSegment> segments;
  Pose2 pose = plan.start;
  for (double covered = 0; covered < duration; covered += segments.back().duration)
  {
    TwistSegment arc{random.uniform(0.5, 2.0), plan.speed, random.uniform(-plan.turn_rate, plan.turn_rate)};
    const double astray = random.uniform(-kPi / 3, kPi / 3);
    if (plan.straight_share > 0 && random.chance(plan.straight_share)) arc.turn_rate = 0;
    if (plan.rest_share > 0 && random.chance(plan.rest_share)) arc.speed = arc.turn_rate = 0;
    const Pose2 middle = compose(pose, arcMotion(arc.speed, arc.turn_rate, 0.5 * arc.duration));
    const Pose2 end = compose(pose, arcMotion(arc.speed, arc.turn_rate, arc.duration));
    if (!inside(plan, middle) || !inside(plan, end))
    {
      const Vector2d home = 0.5 * (plan.low + plan.high) - pose.position();
      const double turn = wrap(std::atan2(home.y(), home.x()) + astray - pose.phi);
      arc = {std::abs(turn) / plan.turn_rate, 0, std::copysign(plan.turn_rate, turn)};
    }
    pose = compose(pose, arcMotion(arc.speed, arc.turn_rate, arc.duration));
    segments.push_back(arc);
  }
  return RobotPath(plan.start, segments);
}
}  // namespace

RobotPath planPath(const PathPlan& plan, double duration, RandomStream& random)
{
  switch (plan.kind)
  {
    case PathKind::circle:
      return planCircle(plan, duration);
    case PathKind::waypoints:
    case PathKind::square:
      return planRoute(plan, duration);
    case PathKind::random_walk:
      return planRandomWalk(plan, duration, random);
    case PathKind::standstill:
      break;
  }
  return RobotPath(plan.start, {});
}
}  // namespace mrpt_ext
