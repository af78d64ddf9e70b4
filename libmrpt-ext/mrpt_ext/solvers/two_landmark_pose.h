#pragma once

#include <span>

#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/solvers/gaussian_point.h"

namespace mrpt_ext
{
/// A known landmark seen as a point: triangulated, or from a range and a bearing.
struct SeenLandmark
{
  Vector2d landmark{0, 0};  ///< world frame [m]
  GaussianPoint in_robot;   ///< robot frame [m]
};

struct PointPose
{
  SolveStatus status = SolveStatus::too_few;
  GaussianPose pose;  ///< set only when status is ok
  double chi2 = 0;    ///< 2 n - 3 degrees of freedom
  double misfit = 0;  ///< largest relative error of a distance between two seen landmarks against the map
};

/// Pose from two or more landmarks seen as points: the rigid fit, weighted by their covariances. For two landmarks the
/// heading starts at atan2 of the landmark difference in the world minus that in the robot frame (paper 001, eq 5, for
/// landmarks anywhere), the position from the weighted mean of both; Gauss-Newton steps then weigh each point by its
/// whole covariance. Covariances all zero: equal weights, covariance scaled to one metre.
/// Status `degenerate`: all landmarks (or all their images) have the same position.
[[nodiscard]] PointPose solvePointPose(std::span<const SeenLandmark> seen);
}  // namespace mrpt_ext
