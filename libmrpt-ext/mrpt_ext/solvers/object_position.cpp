#include "mrpt_ext/solvers/object_position.h"

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
GaussianPoint objectPosition(const GaussianPose& robot, const GaussianPoint& in_robot)
{
  const Matrix2d R = rotation(robot.mean.phi);
  Eigen::Matrix<double, 2, 3> J;  // d object / d pose
  J.leftCols<2>() = Matrix2d::Identity();
  J.col(2) = perpendicular(R * in_robot.mean);
  return {transform(robot.mean, in_robot.mean),
          J * robot.covariance * J.transpose() + R * in_robot.covariance * R.transpose()};
}
}  // namespace mrpt_ext
