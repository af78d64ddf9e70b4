#include "mrpt_ext/solvers/line_of_position.h"

#include <algorithm>

#include "mrpt_ext/solvers/plane.h"
#include "mrpt_ext/solvers/two_circles.h"

namespace mrpt_ext
{
namespace
{
constexpr double kParallel = 1e-9;  // sine below which directions count as one

LocusCrossing crossLines(const PositionLocus& a, const PositionLocus& b)
{
  const double sine = cross(a.direction, b.direction);
  if (std::abs(sine) < kParallel) return {};
  const double along = cross(b.point - a.point, b.direction) / sine;
  return {1, {a.point + along * a.direction, Vector2d(0, 0)}};
}

LocusCrossing crossLineWithCircle(const PositionLocus& line, const PositionLocus& circle)
{
  const Vector2d foot = line.point + line.direction.dot(circle.point - line.point) * line.direction;
  const double half2 = square(circle.radius) - (foot - circle.point).squaredNorm();
  if (half2 <= 0) return {1, {foot, Vector2d(0, 0)}};
  const Vector2d half = std::sqrt(half2) * line.direction;
  return {2, {foot + half, foot - half}};
}
}  // namespace

PositionLocus circleAbout(const Vector2d& centre, double radius) { return {centre, {1, 0}, radius, false}; }

PositionLocus lineThrough(const Vector2d& point, const Vector2d& direction) { return {point, direction, 0, true}; }

std::optional<PositionLocus> circleOfAngle(const Vector2d& a, const Vector2d& b, const Vector2d& unit_a,
                                           const Vector2d& unit_b)
{
  const Vector2d chord = b - a;
  const double length = chord.norm();
  if (!(length > 0)) return std::nullopt;
  const double sine = cross(unit_a, unit_b), cosine = unit_a.dot(unit_b);
  if (std::abs(sine) < kParallel) return lineThrough(a, chord / length);
  // Inscribed angle gamma from a to b: the centre lies chord / (2 tan gamma) to the left of a -> b.
  const Vector2d centre = 0.5 * (a + b) + 0.5 * cosine / sine * perpendicular(chord);
  return circleAbout(centre, 0.5 * length / std::abs(sine));
}

LocusCrossing crossLoci(const PositionLocus& a, const PositionLocus& b)
{
  if (a.straight && b.straight) return crossLines(a, b);
  if (a.straight) return crossLineWithCircle(a, b);
  if (b.straight) return crossLineWithCircle(b, a);
  const TwoCircles circles = intersectCircles({a.point, a.radius}, {b.point, b.radius});
  LocusCrossing crossing{static_cast<int>(circles.candidates().size())};
  std::copy(circles.candidates().begin(), circles.candidates().end(), crossing.points.begin());
  return crossing;
}
}  // namespace mrpt_ext
