#pragma once

#include <Eigen/Core>
#include <cmath>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Derivative of one scalar measurement with respect to the robot pose, order (x, y, phi).
using JacobianRow = Eigen::RowVector3d;

/// Bearing [rad, wrapped, CCW from the sensor's forward axis] under which a sensor at `T_robot_sensor` on a robot at
/// `pose` sees `landmark` (world frame).
[[nodiscard]] inline double predictBearing(const Pose2& pose, const Vector2d& landmark,
                                           const Pose2& T_robot_sensor = {})
{
  const Vector2d d = landmark - transform(pose, T_robot_sensor.position());
  return wrap(std::atan2(d.y(), d.x()) - pose.phi - T_robot_sensor.phi);
}

/// Horizontal range [m] from that sensor to `landmark`.
[[nodiscard]] inline double predictRange(const Pose2& pose, const Vector2d& landmark, const Pose2& T_robot_sensor = {})
{
  return (landmark - transform(pose, T_robot_sensor.position())).norm();
}

/// d bearing / d pose: [dy/r^2, -dx/r^2, -1 - (d . m')/r^2] with d from the sensor to the landmark, r = |d| and
/// m' the sensor offset in world axes (for m = 0 the textbook row). The sensor's yaw does not matter.
/// A landmark on the sensor has no bearing: the row is then zero, which adds no information.
[[nodiscard]] inline JacobianRow bearingJacobian(const Pose2& pose, const Vector2d& landmark,
                                                 const Vector2d& sensor_offset = Vector2d::Zero())
{
  const Vector2d m = rotation(pose.phi) * sensor_offset;
  const Vector2d d = landmark - pose.position() - m;
  const double r2 = d.squaredNorm();
  if (!(r2 > 0)) return JacobianRow::Zero();
  return {d.y() / r2, -d.x() / r2, -1.0 - d.dot(m) / r2};
}

/// d range / d pose: [-dx/r, -dy/r, (dx m'_y - dy m'_x)/r], symbols as above; zero for a landmark on the sensor.
[[nodiscard]] inline JacobianRow rangeJacobian(const Pose2& pose, const Vector2d& landmark,
                                               const Vector2d& sensor_offset = Vector2d::Zero())
{
  const Vector2d m = rotation(pose.phi) * sensor_offset;
  const Vector2d d = landmark - pose.position() - m;
  const double r = d.norm();
  if (!(r > 0)) return JacobianRow::Zero();
  return {-d.x() / r, -d.y() / r, (d.x() * m.y() - d.y() * m.x()) / r};
}

/// Adds one measurement with standard deviation `std` > 0 to the Fisher information of the pose: J^T J / std^2.
inline void addInformation(Matrix3d& information, const JacobianRow& row, double std)
{
  information.noalias() += row.transpose() * row / (std * std);
}
}  // namespace mrpt_ext
