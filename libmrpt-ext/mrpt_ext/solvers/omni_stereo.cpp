#include "mrpt_ext/solvers/omni_stereo.h"

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
constexpr double kParallelRays = 1e-12;  // sine of the angle between the rays

bool isUsableRay(const SightRay& ray)
{
  return ray.origin.allFinite() && std::isfinite(ray.angle) && std::isfinite(ray.std_angle) && ray.std_angle >= 0;
}

Matrix2d pointCovariance(const SightRay& first, double first_distance, const SightRay& second, double second_distance)
{
  const double e1 = first_distance * first.std_angle, e2 = second_distance * second.std_angle;
  // Normals span the plane, so the error is a sum of two independent shifts along the other ray.
  const Vector2d d1 = direction(first.angle), d2 = direction(second.angle);
  const double sine = cross(d1, d2);
  return (square(e1) * d2 * d2.transpose() + square(e2) * d1 * d1.transpose()) / square(sine);
}
}  // namespace

Triangulation triangulate(const SightRay& first, const SightRay& second)
{
  Triangulation result;
  if (!isUsableRay(first) || !isUsableRay(second)) return result;
  const Vector2d d1 = direction(first.angle), d2 = direction(second.angle);
  const Vector2d baseline = second.origin - first.origin;
  const double sine = cross(d1, d2);
  result.status = SolveStatus::degenerate;
  if (std::abs(sine) < kParallelRays || !(baseline.squaredNorm() > 0)) return result;

  result.first_distance = cross(baseline, d2) / sine;
  result.second_distance = cross(baseline, d1) / sine;
  result.status = SolveStatus::behind;
  if (!(result.first_distance > 0 && result.second_distance > 0)) return result;
  result.status = SolveStatus::ok;
  result.point.mean = first.origin + result.first_distance * d1;
  result.point.covariance = pointCovariance(first, result.first_distance, second, result.second_distance);
  return result;
}
}  // namespace mrpt_ext
