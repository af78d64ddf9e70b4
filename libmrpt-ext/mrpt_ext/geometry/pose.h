#pragma once

#include <Eigen/Core>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Pose in the plane: position [m] and heading [rad, counter-clockwise]. `T_a_b` names the pose of b in frame a.
struct Pose2
{
  double x = 0;
  double y = 0;
  double phi = 0;

  [[nodiscard]] Vector2d position() const { return {x, y}; }
  [[nodiscard]] Vector3d vector() const { return {x, y, phi}; }
};

/// Rotation matrix of `phi` [rad].
[[nodiscard]] inline Matrix2d rotation(double phi)
{
  const double c = std::cos(phi), s = std::sin(phi);
  return (Matrix2d() << c, -s, s, c).finished();
}

/// T_a_c from T_a_b and T_b_c; the heading is wrapped.
[[nodiscard]] inline Pose2 compose(const Pose2& T_a_b, const Pose2& T_b_c)
{
  const double c = std::cos(T_a_b.phi), s = std::sin(T_a_b.phi);
  return {T_a_b.x + c * T_b_c.x - s * T_b_c.y, T_a_b.y + s * T_b_c.x + c * T_b_c.y, wrap(T_a_b.phi + T_b_c.phi)};
}

/// `step` (x, y, phi) added to the components of `pose`, the heading wrapped.
[[nodiscard]] inline Pose2 added(const Pose2& pose, const Vector3d& step)
{
  return {pose.x + step.x(), pose.y + step.y(), wrap(pose.phi + step.z())};
}

/// T_b_a from T_a_b.
[[nodiscard]] inline Pose2 inverse(const Pose2& T_a_b)
{
  const double c = std::cos(T_a_b.phi), s = std::sin(T_a_b.phi);
  return {-c * T_a_b.x - s * T_a_b.y, s * T_a_b.x - c * T_a_b.y, wrap(-T_a_b.phi)};
}

/// T_a_b from T_w_a and T_w_b.
[[nodiscard]] inline Pose2 between(const Pose2& T_w_a, const Pose2& T_w_b) { return compose(inverse(T_w_a), T_w_b); }

/// Point given in frame b, expressed in frame a.
[[nodiscard]] inline Vector2d transform(const Pose2& T_a_b, const Vector2d& point_b)
{
  return T_a_b.position() + rotation(T_a_b.phi) * point_b;
}

/// d compose(T_a_b, T_b_c) / d T_a_b, order (x, y, phi).
[[nodiscard]] inline Matrix3d composeJacobianFirst(const Pose2& T_a_b, const Pose2& T_b_c)
{
  const double c = std::cos(T_a_b.phi), s = std::sin(T_a_b.phi);
  Matrix3d J = Matrix3d::Identity();
  J(0, 2) = -s * T_b_c.x - c * T_b_c.y;
  J(1, 2) = c * T_b_c.x - s * T_b_c.y;
  return J;
}

/// d compose(T_a_b, T_b_c) / d T_b_c, order (x, y, phi).
[[nodiscard]] inline Matrix3d composeJacobianSecond(const Pose2& T_a_b)
{
  Matrix3d J = Matrix3d::Identity();
  J.topLeftCorner<2, 2>() = rotation(T_a_b.phi);
  return J;
}

/// True if every coordinate is finite.
[[nodiscard]] inline bool isFinite(const Pose2& pose)
{
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.phi);
}
}  // namespace mrpt_ext
