#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/solvers/gaussian_point.h"
#include "mrpt_ext/solvers/two_circles.h"

namespace mrpt_ext
{
/// Two horizontal ranges to one landmark from two positions of the sensor.
struct RangePair
{
  Vector2d landmark{0, 0};                              ///< world frame [m]
  Vector2d displacement{0, 0};                          ///< second minus first position, world axes [m]
  double first_range = 0, second_range = 0;             ///< [m]
  double first_std = 0, second_std = 0;                 ///< [m]
  Matrix2d displacement_covariance = Matrix2d::Zero();  ///< world axes [m^2]
};

/// One possible pair of sensor positions.
struct RunningFixCandidate
{
  GaussianPoint second;    ///< position at the second range, world frame
  Vector2d first{0, 0};    ///< position at the first range
  bool linearised = true;  ///< false: the covariance is the spread about a tangent point or a gap, see runningFix
};

struct RunningFix
{
  SolveStatus status = SolveStatus::bad_input;
  CircleRelation relation = CircleRelation::not_finite;
  std::vector<RunningFixCandidate> candidates;  ///< two; one when tangent or when the circles miss each other
  bool intersects = false;                      ///< false with a candidate: it is the midpoint of the gap
  double gap = 0;                               ///< [m] by which the circles miss each other
};

/// The running fix of paper 004 (eq 1-6): where was a sensor of known heading that measured two ranges to one landmark
/// and moved in between? Circle 1 about the landmark shifted by the displacement ("virtual landmark"), circle 2 about
/// the landmark. Deviations: `displacement` must be in world axes (the paper's dead reckoning needs a heading for
/// that); degenerate cases are told apart (two_circles); circles that miss each other give the midpoint of the gap with
/// its large covariance instead of nothing (this happens to half of all fixes with a displacement of one sigma).
/// Covariance: inverse of u1 u1^T / (s1^2 + u1^T Sd u1) + u2 u2^T / s2^2 with unit vectors u from the landmark, unless
/// that exceeds the spread over which two nearly touching circles stay within their noise: sqrt(2 rho (gap + s)) along
/// the tangent, rho the radius of relative curvature. Motion towards the landmark ends there.
/// Status: `ok` with candidates; `degenerate` same circle (no motion); `none` concentric; `bad_input`.
[[nodiscard]] RunningFix runningFix(const RangePair& ranges);
}  // namespace mrpt_ext
