#pragma once

#include <array>

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/solve_status.h"

namespace mrpt_ext
{
/// A directed line of sight to a known landmark, from any sensor position on the robot or on its recent trajectory.
struct NoncentralBearing
{
  Vector2d landmark{0, 0};   ///< world frame [m]
  Vector2d origin{0, 0};     ///< position of the sensor, robot frame [m]
  Vector2d direction{1, 0};  ///< unit vector, robot frame
};

/// All poses for which three lines of sight from different positions meet their landmarks.
struct NoncentralThreeBearingPose
{
  SolveStatus status = SolveStatus::bad_input;
  int count = 0;  ///< poses: up to 2
  std::array<Pose2, 2> poses;
  double quality = 0;  ///< of the heading, in [0, 1]: 1 for the best geometry
};

/// Paper 000 for three bearings from different positions (a non-central camera): several cameras, or a short
/// trajectory. With v_i = Rot(h)^T (L_i - t) the landmark in the robot frame, cross(d_i, v_i - o_i) = 0 is linear in
/// cos h, sin h and q = Rot(h)^T t. The three directions of a plane are dependent, sum w_i d_i = 0 with w_1 =
/// cross(d_2, d_3) and so on; the same sum of the three equations has no q any more and reads A cos h - B sin h = E: a
/// line that meets the unit circle in up to two headings. E = 0 when all origins are one: then the second is the first
/// turned by 180 degrees, with every landmark behind its bearing, and the pose is that of solveThreeBearingPose.
/// Status: `ok`; `behind` the lines meet, but a landmark would lie behind; `none` no heading; `degenerate` parallel
/// lines of sight, or every heading fits (one origin: robot and landmarks on a circle); `bad_input` not finite.
[[nodiscard]] NoncentralThreeBearingPose solveNoncentralThreeBearingPose(const std::array<NoncentralBearing, 3>& lines);
}  // namespace mrpt_ext
