#include "mrpt_ext/vision/tags/pinhole_camera.h"

#include <Eigen/LU>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kNearestDepth = 1e-6;  ///< [m]
constexpr int kInversionSteps = 30;
constexpr double kInverted = 1e-12;  ///< of x/z

struct Distorted
{
  Eigen::Vector2d at;
  Eigen::Matrix2d by_ray;
};

/// Where the lens moves a ray (x/z, y/z) to.
Distorted distorted(const PinholeCamera& lens, const Eigen::Vector2d& ray)
{
  const double x = ray.x(), y = ray.y(), r2 = ray.squaredNorm();
  const double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  const double slope = 2 * (lens.k1 + r2 * (2 * lens.k2 + 3 * r2 * lens.k3));  // of `radial`, by x over x
  const double mixed = x * y * slope + 2 * lens.p1 * x + 2 * lens.p2 * y;
  Distorted result;
  result.at = {x * radial + 2 * lens.p1 * x * y + lens.p2 * (r2 + 2 * x * x),
               y * radial + lens.p1 * (r2 + 2 * y * y) + 2 * lens.p2 * x * y};
  result.by_ray << radial + x * x * slope + 2 * lens.p1 * y + 6 * lens.p2 * x, mixed, mixed,
      radial + y * y * slope + 6 * lens.p1 * y + 2 * lens.p2 * x;
  return result;
}
}  // namespace

std::optional<PinholeCamera::Projection> PinholeCamera::project(const Eigen::Vector3d& point) const
{
  if (!(point.z() > kNearestDepth)) return std::nullopt;
  const Eigen::Vector2d ray = point.head<2>() / point.z();
  const Distorted lens = distorted(*this, ray);
  if (!(lens.by_ray.determinant() > 0)) return std::nullopt;
  Eigen::Matrix<double, 2, 3> ray_by_point;
  ray_by_point << Eigen::Matrix2d::Identity(), -ray;
  const Eigen::Vector2d focal(fx, fy);
  return Projection{focal.cwiseProduct(lens.at) + Eigen::Vector2d(cx, cy),
                    focal.asDiagonal() * lens.by_ray * ray_by_point / point.z()};
}

std::optional<Eigen::Vector2d> PinholeCamera::rayOf(const Eigen::Vector2d& pixel) const
{
  const Eigen::Vector2d wanted((pixel.x() - cx) / fx, (pixel.y() - cy) / fy);
  Eigen::Vector2d ray = wanted;
  for (int step = 0; step < kInversionSteps; ++step)
  {
    const Distorted lens = distorted(*this, ray);
    if (!(lens.by_ray.determinant() > 0)) return std::nullopt;
    const Eigen::Vector2d move = lens.by_ray.inverse() * (wanted - lens.at);
    ray += move;
    if (move.norm() < kInverted) return ray;
  }
  return std::nullopt;
}

Eigen::Matrix3d PinholeCamera::levelAxes() const
{
  const double sp = std::sin(pitch), cp = std::cos(pitch);
  const Eigen::Vector3d ahead(cp, 0, -sp), right(0, -1, 0), down(-sp, 0, -cp);
  Eigen::Matrix3d axes;
  axes << std::cos(roll) * right + std::sin(roll) * down, std::cos(roll) * down - std::sin(roll) * right, ahead;
  return axes;
}
}  // namespace mrpt_ext
