#pragma once

#include <span>

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/solve_status.h"

namespace mrpt_ext
{
/// A known landmark [m, world frame] and the unit vector of its bearing (cos b, sin b), robot frame.
struct UnitBearing
{
  Vector2d landmark{0, 0};
  Vector2d unit{1, 0};
};

struct BearingPoseFromUnits
{
  SolveStatus status = SolveStatus::too_few;  ///< ok, too_few, degenerate (also when not finite) or behind
  Vector2d position{0, 0};                    ///< [m], world frame; set only when status is ok
  Vector2d heading{1, 0};                     ///< unit vector; set only when status is ok
  double quality = 0;                         ///< det(S) / (n-1)^2, in [0, 1/4]: of the geometry
};

/// Paper 000, eq 1-6, for many calls: the same pose as solveBearingPoseLinear() (see there for what it is good for),
/// but from unit vectors, without trigonometry, memory or residuals. Deviation: the unknown f is multiplied by the unit
/// vector of the reference bearing (three_bearing_pose.h), k = e^(-j phi) / r_0, so that a row is conj(u_i) (L_i - L_0)
/// and its right side the sine between two bearings; the weights and the determinant stay what they are.
[[nodiscard]] BearingPoseFromUnits solveBearingPoseFromUnits(std::span<const UnitBearing> bearings);
}  // namespace mrpt_ext
