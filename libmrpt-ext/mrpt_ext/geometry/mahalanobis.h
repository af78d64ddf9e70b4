#pragma once

#include <Eigen/Cholesky>

#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// Coordinates of `to` minus those of `from`, in the axes of their common frame [m, m, rad]; the heading is wrapped.
[[nodiscard]] inline Vector3d difference(const Pose2& from, const Pose2& to)
{
  return {to.x - from.x, to.y - from.y, wrap(to.phi - from.phi)};
}

/// Squared Mahalanobis distance of two poses under `covariance` (x, y, phi), heading difference wrapped.
/// Not a number or infinite where the covariance is singular.
[[nodiscard]] inline double mahalanobis2(const Pose2& a, const Pose2& b, const Matrix3d& covariance)
{
  const Vector3d e = difference(a, b);
  return e.dot(covariance.llt().solve(e));
}

/// True if two estimates are within so many standard deviations of each other, by the uncertainty of both.
[[nodiscard]] inline bool agree(const GaussianPose& a, const GaussianPose& b, double stds)
{
  return mahalanobis2(a.mean, b.mean, a.covariance + b.covariance + 1e-9 * Matrix3d::Identity()) < square(stds);
}

/// True if every coordinate of `pose` is within `stds` standard deviations of the mean: cheaper than mahalanobis2().
[[nodiscard]] inline bool isWithin(const GaussianPose& gaussian, const Pose2& pose, double stds)
{
  const Vector3d e = difference(gaussian.mean, pose);
  for (Eigen::Index k = 0; k < 3; ++k)
    if (square(e(k)) > square(stds) * gaussian.covariance(k, k)) return false;
  return true;
}
}  // namespace mrpt_ext
