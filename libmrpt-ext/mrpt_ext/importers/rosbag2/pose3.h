#pragma once

#include <Eigen/Geometry>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Pose in space: of the transforms between the frames of a robot, before they become planar.
struct Pose3
{
  Vector3d position = Vector3d::Zero();  ///< [m]
  Matrix3d rotation = Matrix3d::Identity();

  [[nodiscard]] Pose3 operator*(const Pose3& next) const
  {
    return {position + rotation * next.position, rotation * next.rotation};
  }
  [[nodiscard]] Pose3 inverse() const { return {-(rotation.transpose() * position), rotation.transpose()}; }
  /// In the plane; the heading is that of the axis `forward`.
  [[nodiscard]] Pose2 planar(const Vector3d& forward = Vector3d::UnitX()) const
  {
    const Vector3d axis = rotation * forward;
    return {position.x(), position.y(), std::atan2(axis.y(), axis.x())};
  }
};

/// Axes of a camera (x right, y down, z into the scene) in those of a body (x forward, y left, z up).
[[nodiscard]] inline Matrix3d opticalRotation() { return (Matrix3d() << 0, 0, 1, -1, 0, 0, 0, -1, 0).finished(); }
}  // namespace mrpt_ext
