#pragma once

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Point in the plane with covariance [m, m^2]; the frame is stated where it is used.
struct GaussianPoint
{
  Vector2d mean{0, 0};
  Matrix2d covariance = Matrix2d::Zero();
};

/// Covariance of a pose (x, y, phi) from that of its position at a given heading, the derivative of the position by the
/// heading, and the heading's variance [rad^2].
[[nodiscard]] inline Matrix3d withHeading(const Matrix2d& position, const Vector2d& d_position, double variance)
{
  Matrix3d covariance;
  covariance.topLeftCorner<2, 2>() = position + variance * d_position * d_position.transpose();
  covariance.topRightCorner<2, 1>() = variance * d_position;
  covariance.bottomLeftCorner<1, 2>() = variance * d_position.transpose();
  covariance(2, 2) = variance;
  return covariance;
}
}  // namespace mrpt_ext
