#pragma once

#include <array>
#include <span>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// How two circles lie to each other.
enum class CircleRelation
{
  two,              ///< two intersections
  tangent,          ///< one (double) intersection, to rounding
  separate,         ///< side by side, no intersection
  contained,        ///< one inside the other, no intersection
  concentric,       ///< same centre, different radii
  coincident,       ///< same circle: infinitely many intersections
  negative_radius,  ///< bad input
  not_finite        ///< bad input
};

struct Circle
{
  Vector2d centre{0, 0};
  double radius = 0;
};

/// Intersections of two circles.
struct TwoCircles
{
  CircleRelation relation = CircleRelation::not_finite;
  int count = 0;                   ///< 2, 1 (tangent) or 0
  std::array<Vector2d, 2> points;  ///< the first lies left of the direction from the first to the second centre
  Vector2d closest{0, 0};          ///< separate, contained: midpoint of the gap on the line of centres
  double gap = 0;                  ///< separate, contained: width of the gap, > 0
  TwoCircles() { points.fill(Vector2d::Zero()); }

  /// The intersections; without any, the middle of the gap if there is one.
  [[nodiscard]] std::span<const Vector2d> candidates() const
  {
    return gap > 0 ? std::span(&closest, 1) : std::span(points).first(static_cast<std::size_t>(count));
  }
};

/// Intersects two circles (paper 004, eq 1-4).
/// Deviation: eq 4 solves for x = A + B y and divides by the x difference of the centres, which fails for centres one
/// above the other and loses digits near it. Here the points are written along and across the line of centres, which
/// has no preferred axis; the half chord is a product of four differences, accurate also for grazing circles.
[[nodiscard]] TwoCircles intersectCircles(const Circle& first, const Circle& second);
}  // namespace mrpt_ext
