#include "mrpt_ext/solvers/sight_agreement.h"

#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
constexpr double kDeviations = 3;
constexpr double kRoughParallax = 0.5;  ///< share that a rough distance leaves unknown

bool confirms(const RangedSight& one, const RangedSight& other, double mounting)
{
  const Vector2d point =
      one.ray.origin + one.distance * Vector2d(std::cos(one.ray.angle), std::sin(one.ray.angle)) - other.ray.origin;
  const double expected = std::atan2(point.y(), point.x()), parallax = std::abs(wrap(expected - one.ray.angle));
  return std::abs(wrap(other.ray.angle - expected)) <=
         mounting + kDeviations * std::hypot(one.ray.std_angle, other.ray.std_angle) + kRoughParallax * parallax;
}
}  // namespace

std::vector<bool> confirmedSights(const std::vector<RangedSight>& sights, double mounting)
{
  std::vector<bool> confirmed(sights.size(), sights.size() == 1);
  for (std::size_t i = 0; i < sights.size(); ++i)
    for (std::size_t j = 0; j < sights.size(); ++j)
      if (i != j && confirms(sights[i], sights[j], mounting) && confirms(sights[j], sights[i], mounting))
        confirmed[i] = true;
  return confirmed;
}
}  // namespace mrpt_ext
