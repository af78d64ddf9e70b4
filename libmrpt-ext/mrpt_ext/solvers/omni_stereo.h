#pragma once

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/solvers/gaussian_point.h"

namespace mrpt_ext
{
/// A line of sight, in any frame: from `origin` in the direction `angle`.
struct SightRay
{
  Vector2d origin{0, 0};  ///< [m]
  double angle = 0;       ///< [rad]
  double std_angle = 0;   ///< [rad]
};

struct Triangulation
{
  SolveStatus status = SolveStatus::bad_input;
  GaussianPoint point;        ///< in the frame of the rays
  double first_distance = 0;  ///< along each ray [m]; set also for `behind`, where one of them is negative
  double second_distance = 0;
};

/// Where two lines of sight meet: the triangulation of paper 001 (eq 1-2) for any two cameras.
/// Deviation: eq 1-2 divide by differences of tangents, fail where a slant is 90 degrees, and return the mirror point
/// when the rays diverge; rays cut each other without either, s = cross(c_j - c_i, d_j) / cross(d_i, d_j).
/// Covariance: inverse of sum n n^T / (s sigma)^2, n the normal of each ray; the range error grows with range squared.
/// Status: `degenerate` parallel rays, `behind` the lines meet behind a camera, `bad_input` not finite.
[[nodiscard]] Triangulation triangulate(const SightRay& first, const SightRay& second);
}  // namespace mrpt_ext
