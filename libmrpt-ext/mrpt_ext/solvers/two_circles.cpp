#include "mrpt_ext/solvers/two_circles.h"

#include <algorithm>

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
constexpr double kRelativeTolerance = 1e-12;

bool isFiniteCircle(const Circle& c) { return c.centre.allFinite() && std::isfinite(c.radius); }

TwoCircles withoutPoints(CircleRelation relation)
{
  TwoCircles result;
  result.relation = relation;
  return result;
}

/// Midpoint of the gap between two circles that do not meet; `u` points from the first to the second centre.
TwoCircles gapBetween(const Circle& first, const Circle& second, double distance, const Vector2d& u)
{
  const bool separate = distance > first.radius + second.radius;
  TwoCircles result = withoutPoints(separate ? CircleRelation::separate : CircleRelation::contained);
  // Contained: the narrow side lies beyond the inner centre, seen from the outer one.
  const double side_first = separate || first.radius >= second.radius ? 1.0 : -1.0;
  const double side_second = separate ? -1.0 : side_first;
  const Vector2d on_first = first.centre + side_first * first.radius * u;
  const Vector2d on_second = second.centre + side_second * second.radius * u;
  result.closest = 0.5 * (on_first + on_second);
  result.gap = separate ? distance - first.radius - second.radius : std::abs(first.radius - second.radius) - distance;
  return result;
}
}  // namespace

TwoCircles intersectCircles(const Circle& first, const Circle& second)
{
  if (!isFiniteCircle(first) || !isFiniteCircle(second)) return withoutPoints(CircleRelation::not_finite);
  const double r1 = first.radius, r2 = second.radius;
  if (r1 < 0 || r2 < 0) return withoutPoints(CircleRelation::negative_radius);

  const Vector2d centres = second.centre - first.centre;
  const double distance = centres.norm();
  const double largest = std::max(r1, r2);
  if (distance <= kRelativeTolerance * largest)
    return withoutPoints(std::abs(r1 - r2) <= kRelativeTolerance * largest ? CircleRelation::coincident
                                                                           : CircleRelation::concentric);

  const Vector2d u = centres / distance;
  const double difference = std::abs(r1 - r2), sum = r1 + r2;
  const double half_chord2 = ((sum - distance) / distance) * ((sum + distance) / distance) * (distance - difference) *
                             (distance + difference) / 4;
  const double tolerance = kRelativeTolerance * square(largest);
  if (half_chord2 < -tolerance) return gapBetween(first, second, distance, u);

  TwoCircles result;
  const double along = (distance + (r1 - r2) * (sum / distance)) / 2;
  const Vector2d foot = first.centre + along * u;
  result.relation = half_chord2 <= tolerance ? CircleRelation::tangent : CircleRelation::two;
  result.count = result.relation == CircleRelation::two ? 2 : 1;
  const Vector2d chord =
      result.count == 2 ? Vector2d(std::sqrt(half_chord2) * perpendicular(u)) : Vector2d(Vector2d::Zero());
  result.points = {Vector2d(foot + chord), Vector2d(foot - chord)};
  return result;
}
}  // namespace mrpt_ext
