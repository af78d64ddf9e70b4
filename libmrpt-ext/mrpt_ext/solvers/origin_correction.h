#pragma once

#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/solvers/two_pole_pose.h"

namespace mrpt_ext
{
/// Factor per axis and pole that makes a measurement taken at the origin exact.
struct OriginCorrection
{
  SolveStatus status = SolveStatus::bad_input;
  Vector2d p_factor{1, 1};  ///< left pole
  Vector2d q_factor{1, 1};  ///< right pole
};

/// Calibration of paper 001, eq 8: with the robot at the origin and beta = 0, factors -Fw / x_p, Fd / y_p, Fw / x_q,
/// Fd / y_q from the poles as then measured (better as the mean of several frames: the noise of this measurement is
/// copied into every later one). Kept for comparison with the paper: it is undefined where a coordinate is 0
/// (`degenerate`), the wrong form for a turned camera, and can make things worse; see camera_yaw_calibration.
/// No app uses it.
[[nodiscard]] OriginCorrection calibrateAtOrigin(const Vector2d& p_at_origin, const Vector2d& q_at_origin,
                                                 const PoleField& field);

[[nodiscard]] inline Vector2d correctLeftPole(const OriginCorrection& c, const Vector2d& p)
{
  return c.p_factor.cwiseProduct(p);
}
[[nodiscard]] inline Vector2d correctRightPole(const OriginCorrection& c, const Vector2d& q)
{
  return c.q_factor.cwiseProduct(q);
}
}  // namespace mrpt_ext
