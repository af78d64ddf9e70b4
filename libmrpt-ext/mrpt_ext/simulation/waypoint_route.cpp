#include "mrpt_ext/simulation/waypoint_route.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
struct Leg
{
  double length = 0;
  double heading = 0;
};

std::vector<Leg> legsOf(const PathPlan& plan)
{
  const std::size_t n = plan.waypoints.size();
  if (n < 2) throw configurationError("path: " + std::to_string(n) + " waypoints, expected at least 2");
  std::vector<Leg> legs;
  for (std::size_t i = 0; i + (plan.closed ? 0 : 1) < n; ++i)
  {
    const Vector2d leg = plan.waypoints[(i + 1) % n] - plan.waypoints[i];
    if (!(leg.norm() > 0))
      throw configurationError("path: waypoint " + std::to_string(i + 1) + " coincides with the next one");
    legs.push_back({leg.norm(), std::atan2(leg.y(), leg.x())});
  }
  return legs;
}

/// Length of a leg that a rounded corner of this turn takes away on both sides.
double cornerLength(const PathPlan& plan, double turn) { return plan.turn_radius * std::tan(0.5 * std::abs(turn)); }

void checkCorner(const PathPlan& plan, const Leg& before, const Leg& after, std::size_t waypoint)
{
  const double turn = wrap(after.heading - before.heading);
  if (std::abs(turn) < kPi - 1e-9 && cornerLength(plan, turn) <= 0.5 * std::min(before.length, after.length)) return;
  throw configurationError("path: the corner at waypoint " + std::to_string(waypoint + 1) +
                           " does not fit, expected a smaller turn radius (0: turn in place) or longer legs");
}

TwistSegment corner(const PathPlan& plan, double turn)
{
  const double speed = plan.turn_radius > 0 ? plan.speed : 0;
  const double rate = plan.turn_radius > 0 ? plan.speed / plan.turn_radius : plan.turn_rate;
  return {std::abs(turn) / rate, speed, std::copysign(rate, turn)};
}
}  // namespace

PlannedRoute followWaypoints(const PathPlan& plan)
{
  const std::vector<Leg> legs = legsOf(plan);
  const bool rounded = plan.turn_radius > 0;
  const bool from_middle = plan.closed && rounded;
  const std::size_t corners = plan.closed ? legs.size() : legs.size() - 1;

  PlannedRoute planned;
  planned.start = {plan.waypoints[0].x(), plan.waypoints[0].y(), legs[0].heading};
  if (from_middle) planned.start = compose(planned.start, {0.5 * legs[0].length, 0, 0});
  double cut_before = from_middle ? 0.5 * legs[0].length : 0;  // of the present leg, already behind
  for (std::size_t i = 0; i < legs.size(); ++i)
  {
    const bool has_corner = i < corners;
    const Leg& next = legs[(i + 1) % legs.size()];
    const double turn = has_corner ? wrap(next.heading - legs[i].heading) : 0;
    if (has_corner && rounded) checkCorner(plan, legs[i], next, (i + 1) % plan.waypoints.size());
    const double cut_after = has_corner ? cornerLength(plan, turn) : 0;
    const double straight = legs[i].length - cut_before - cut_after;
    if (straight > 0) planned.segments.push_back({straight / plan.speed, plan.speed, 0});
    if (turn != 0) planned.segments.push_back(corner(plan, turn));
    cut_before = cut_after;
  }
  const double rest = 0.5 * legs[0].length - cut_before;  // back to the middle of the first leg
  if (from_middle && rest > 0) planned.segments.push_back({rest / plan.speed, plan.speed, 0});
  return planned;
}
}  // namespace mrpt_ext
