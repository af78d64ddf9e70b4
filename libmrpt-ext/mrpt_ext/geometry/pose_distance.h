#pragma once

#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// Coordinates of `to` minus those of `from`, in the axes of their common frame [m, m, rad]; the heading is wrapped.
[[nodiscard]] inline Vector3d difference(const Pose2& from, const Pose2& to)
{
  return {to.x - from.x, to.y - from.y, wrap(to.phi - from.phi)};
}

/// Squared Mahalanobis distance of `pose` from the mean; the covariance must not be singular.
[[nodiscard]] double mahalanobis2(const GaussianPose& gaussian, const Pose2& pose);

/// True if every coordinate of `pose` is within `stds` standard deviations of the mean: cheaper than mahalanobis2().
[[nodiscard]] inline bool isWithin(const GaussianPose& gaussian, const Pose2& pose, double stds)
{
  const Vector3d e = difference(gaussian.mean, pose);
  for (Eigen::Index k = 0; k < 3; ++k)
    if (square(e(k)) > square(stds) * gaussian.covariance(k, k)) return false;
  return true;
}
}  // namespace mrpt_ext
