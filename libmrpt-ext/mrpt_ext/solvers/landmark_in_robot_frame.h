#pragma once

#include <array>

#include "mrpt_ext/solvers/two_circles.h"

namespace mrpt_ext
{
/// Where a landmark is, seen from a robot that measured two ranges to it and knows only how it moved in between.
struct LandmarkInRobotFrame
{
  CircleRelation relation = CircleRelation::not_finite;
  int count = 0;                       ///< 2: mirror images about the line of motion; 1: on that line; else 0
  std::array<Vector2d, 2> candidates;  ///< from the second position, robot axes [m]
  LandmarkInRobotFrame() { candidates.fill(Vector2d::Zero()); }
};

/// Two ranges and the displacement in robot axes (paper 004 without its absolute heading): the landmark follows up to
/// its mirror image about the displacement. Turning everything about the landmark changes no measurement, so the pose
/// in the world stays on a ring (pose_ring) until a heading, a second landmark or the field's bounds close it.
/// No app uses it; window_landmark.h is the general form.
[[nodiscard]] LandmarkInRobotFrame landmarkInRobotFrame(const Vector2d& displacement_robot, double first_range,
                                                        double second_range);
}  // namespace mrpt_ext
