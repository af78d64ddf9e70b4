#pragma once

#include <span>

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/solve_status.h"

namespace mrpt_ext
{
/// Below this ratio (BearingPoseFromUnits::det_ratio) the robot and all landmarks lie on one circle or line: no pose.
inline constexpr double kSingularBearingRatio = 1e-10;

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
  Vector2d k{0, 0};      ///< e^(-j phi) / |L_0 - R| as a complex number [1/m]; set when status is ok or behind
  double det_ratio = 0;  ///< det(S) / (n-1)^2, in [0, 1/4]: quality of the geometry
};

/// Paper 000, eq 1-6, from unit vectors: no trigonometry, and no heap memory up to 65 bearings. The numbers behind
/// solveBearingPoseLinear() (see there for what the pose is good for). Deviation: the unknown f is multiplied by the
/// unit vector of the reference bearing (three_bearing_pose.h), k = e^(-j phi) / r_0, so that a row is conj(u_i) (L_i -
/// L_0) and its right side the sine between two bearings; the weights and the determinant stay what they are.
[[nodiscard]] BearingPoseFromUnits solveBearingPoseFromUnits(std::span<const UnitBearing> bearings);
}  // namespace mrpt_ext
