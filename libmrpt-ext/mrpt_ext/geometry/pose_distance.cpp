#include "mrpt_ext/geometry/pose_distance.h"

#include <Eigen/Cholesky>

namespace mrpt_ext
{
double mahalanobis2(const GaussianPose& gaussian, const Pose2& pose)
{
  const Vector3d e = difference(gaussian.mean, pose);
  return e.dot(gaussian.covariance.ldlt().solve(e));
}
}  // namespace mrpt_ext
