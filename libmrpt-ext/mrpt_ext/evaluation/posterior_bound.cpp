#include "mrpt_ext/evaluation/posterior_bound.h"

#include <Eigen/LU>

namespace mrpt_ext
{
const Matrix3d& BoundRecursion::advance(const BoundStep& step)
{
  Matrix3d& P = covariance_;
  const Matrix3d F = composeJacobianFirst(pose_, step.increment);
  const Matrix3d G = composeJacobianSecond(pose_);
  Matrix3d noise = step.odometry_covariance;
  noise.diagonal() += step.odometry_std.cwiseAbs2();
  const Matrix3d Q = G * noise * G.transpose();
  const Matrix3d predicted = Q + F * P * F.transpose();
  // (predicted^-1 + I)^-1 without inverting `predicted`: it may be close to singular along noise-free axes.
  P = (Matrix3d::Identity() + predicted * step.measurement_information).partialPivLu().solve(predicted);
  P = (0.5 * (P + P.transpose())).eval();
  pose_ = compose(pose_, step.increment);
  return P;
}
}  // namespace mrpt_ext
