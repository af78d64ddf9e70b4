#include "mrpt_ext/solvers/landmark_in_robot_frame.h"

namespace mrpt_ext
{
LandmarkInRobotFrame landmarkInRobotFrame(const Vector2d& displacement_robot, double first_range, double second_range)
{
  // With v from the second position: |v| = second range, |v + d| = first range.
  const TwoCircles circles = intersectCircles({-displacement_robot, first_range}, {Vector2d::Zero(), second_range});
  LandmarkInRobotFrame result;
  result.relation = circles.relation;
  result.count = circles.count;
  result.candidates = circles.points;
  return result;
}
}  // namespace mrpt_ext
