#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <optional>

namespace mrpt_ext
{
/// A pinhole camera with the lens distortion of Brown and Conrady, coefficients as OpenCV and ROS ("plumb_bob") count
/// them. Camera axes: x right, y down, z along the optical axis. Pixel centres are at integers.
struct PinholeCamera
{
  cv::Size size;                  ///< [px]; empty: any
  double fx = 0, fy = 0;          ///< [px]
  double cx = 0, cy = 0;          ///< [px]
  double k1 = 0, k2 = 0, k3 = 0;  ///< radial distortion
  double p1 = 0, p2 = 0;          ///< tangential distortion
  double pitch = 0;               ///< [rad] positive: looking down
  double roll = 0;                ///< [rad] positive: the image's right side is lower

  /// A pixel and its derivative by the point that it shows.
  struct Projection
  {
    Eigen::Vector2d pixel;
    Eigen::Matrix<double, 2, 3> by_point;
  };
  /// Of a point in camera axes [m]; nothing behind the camera, nor where the lens would fold the image.
  [[nodiscard]] std::optional<Projection> project(const Eigen::Vector3d& point) const;
  /// (x/z, y/z) of the points that a pixel shows; nothing where the distortion has no inverse.
  [[nodiscard]] std::optional<Eigen::Vector2d> rayOf(const Eigen::Vector2d& pixel) const;
  /// From camera axes to level ones: x forward, y left, z up.
  [[nodiscard]] Eigen::Matrix3d levelAxes() const;
};
}  // namespace mrpt_ext
