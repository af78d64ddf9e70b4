#pragma once

#include <Eigen/Geometry>

#include "mrpt_ext/vision/mirror_axis.h"
#include "synthetic_mirror.h"

namespace mrpt_ext::testing
{
/// A conic mirror above a pinhole, apex down, its axis beside the camera's; far vertical edges all around.
struct ConePicture
{
  cv::Size size{640, 480};
  double focal = 505;  ///< [px]
  MirrorAxis mirror{{322.3, 238.6}, degToRad(52), degToRad(24), {}, {}};
  double apex = 0.06;                                      ///< [m] above the pinhole
  Eigen::Vector2d offset{0, 0};                            ///< [m] of the mirror's axis
  Eigen::Vector2d camera_tilt{0, 0}, vertical_tilt{0, 0};  ///< [rad] as in MirrorAxis
  std::vector<Sector> sectors{{-170, 200}, {-120, 90}, {-60, 180}, {-20, 120}, {35, 210}, {80, 60}, {140, 150}};

  /// By exact reflection of the ray through an image point.
  [[nodiscard]] double brightnessAt(double u, double v) const
  {
    const Eigen::Vector3d ray = upright(camera_tilt) * Eigen::Vector3d((u - mirror.principal_point.x) / focal,
                                                                       (v - mirror.principal_point.y) / focal, 1);
    const double slope = std::tan(mirror.cone_half_angle);
    // |t ray - offset| = (t - apex) slope, horizontally, at the height t.
    const Eigen::Vector2d across = ray.head<2>() / ray.z();
    const double a = across.squaredNorm() - slope * slope;
    const double b = -across.dot(offset) + slope * slope * apex;
    const double c = offset.squaredNorm() - slope * slope * apex * apex;
    const double height = (-b - std::sqrt(std::max(0.0, b * b - a * c))) / a;
    const Eigen::Vector2d radial = height * across - offset;
    const double rim_height = apex * slope / (slope - std::tan(mirror.rim_angle));
    if (!(height > apex) || height > rim_height) return 10;
    Eigen::Vector3d normal;
    normal << std::cos(mirror.cone_half_angle) * radial.normalized(), -std::sin(mirror.cone_half_angle);
    const Eigen::Vector3d seen = upright(vertical_tilt) * (ray - 2 * ray.dot(normal) * normal);
    return brightnessTowards(sectors, std::atan2(seen.y(), seen.x()));
  }

  /// Turns the direction that is seen at a tilt upwards.
  [[nodiscard]] static Eigen::Matrix3d upright(const Eigen::Vector2d& tilt)
  {
    if (tilt.isZero()) return Eigen::Matrix3d::Identity();
    return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d(tilt.x(), tilt.y(), 1), Eigen::Vector3d::UnitZ())
        .toRotationMatrix();
  }
};
}  // namespace mrpt_ext::testing
