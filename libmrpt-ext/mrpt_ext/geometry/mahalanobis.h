#pragma once

#include <Eigen/Cholesky>

#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// Squared Mahalanobis distance of two poses under `covariance` (x, y, phi), heading difference wrapped.
/// Not a number or infinite where the covariance is singular.
[[nodiscard]] inline double mahalanobis2(const Pose2& a, const Pose2& b, const Matrix3d& covariance)
{
  Vector3d difference = a.vector() - b.vector();
  difference.z() = wrap(difference.z());
  return difference.dot(covariance.llt().solve(difference));
}
}  // namespace mrpt_ext
