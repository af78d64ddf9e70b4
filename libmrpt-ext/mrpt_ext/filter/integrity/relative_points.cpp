#include "mrpt_ext/filter/integrity/relative_points.h"

namespace mrpt_ext
{
void RelativePoints::move(const Pose2& step, const Matrix3d& covariance)
{
  const Matrix2d back = rotation(step.phi).transpose();
  Eigen::MatrixXd by_step(positions_.size(), 3);
  for (Eigen::Index k = 0; k < positions_.size(); k += 2)
  {
    const Vector2d moved = back * (positions_.segment<2>(k) - step.position());
    positions_.segment<2>(k) = moved;
    by_step.middleRows<2>(k) << -back, Vector2d(moved.y(), -moved.x());
    covariance_.middleRows<2>(k) = (back * covariance_.middleRows<2>(k)).eval();
  }
  for (Eigen::Index k = 0; k < positions_.size(); k += 2)
    covariance_.middleCols<2>(k) = (covariance_.middleCols<2>(k) * back.transpose()).eval();
  covariance_ += by_step * covariance * by_step.transpose();
}

void RelativePoints::add(const Vector2d& position, const Matrix2d& covariance)
{
  const Eigen::Index n = positions_.size();
  positions_.conservativeResize(n + 2);
  positions_.tail<2>() = position;
  covariance_.conservativeResize(n + 2, n + 2);
  covariance_.rightCols<2>().setZero();
  covariance_.bottomRows<2>().setZero();
  covariance_.bottomRightCorner<2, 2>() = covariance;
}

void RelativePoints::remove(Eigen::Index point)
{
  const Eigen::Index n = positions_.size(), at = 2 * point, after = n - at - 2;
  positions_.segment(at, after) = positions_.tail(after).eval();
  covariance_.middleRows(at, after) = covariance_.bottomRows(after).eval();
  covariance_.middleCols(at, after) = covariance_.rightCols(after).eval();
  positions_.conservativeResize(n - 2);
  covariance_.conservativeResize(n - 2, n - 2);
}

void RelativePoints::update(Eigen::Index point, const Vector2d& measured, const Matrix2d& covariance)
{
  // In axes in which the measurement has variances of one, and what is known of the point is independent.
  const Matrix2d whitening = Matrix2d(covariance.llt().matrixL()).inverse();
  const Eigen::SelfAdjointEigenSolver<Matrix2d> known(whitening * this->covariance(point) * whitening.transpose());
  for (int axis = 0; axis < 2; ++axis)
  {
    const double before = known.eigenvalues()[axis];
    if (!(before > 1)) continue;
    // Measured so imprecisely that afterwards it is known as one measurement tells.
    const double total = before + before / (before - 1);
    const Eigen::RowVector2d row = known.eigenvectors().col(axis).transpose() * whitening;
    const Eigen::VectorXd gain = covariance_.middleCols<2>(2 * point) * row.transpose() / total;
    positions_ += gain * row.dot(measured - position(point));
    covariance_ -= total * gain * gain.transpose();
  }
}
}  // namespace mrpt_ext
