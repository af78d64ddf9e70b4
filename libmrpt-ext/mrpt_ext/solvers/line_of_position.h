#pragma once

#include <array>
#include <optional>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Where one measurement, or two together, allow a position: a circle or a straight line.
struct PositionLocus
{
  Vector2d point{0, 0};      ///< centre of the circle, or a point of the line
  Vector2d direction{1, 0};  ///< of a line, unit
  double radius = 0;         ///< of a circle [m]; not used for a line
  bool straight = false;
};

/// All positions at the distance `radius` from `centre`: a range.
[[nodiscard]] PositionLocus circleAbout(const Vector2d& centre, double radius);

/// The line through `point`: a bearing with the heading known.
[[nodiscard]] PositionLocus lineThrough(const Vector2d& point, const Vector2d& direction);

/// All positions from which `a` and `b` are seen under the directed angle between `unit_a` and `unit_b` or its
/// supplement: two bearings (inscribed angle). A line when the angle is 0 or pi; nothing when `a` and `b` coincide.
[[nodiscard]] std::optional<PositionLocus> circleOfAngle(const Vector2d& a, const Vector2d& b, const Vector2d& unit_a,
                                                         const Vector2d& unit_b);

/// Common points of two loci; if they do not meet, the point between them.
struct LocusCrossing
{
  int count = 0;  ///< 0 for parallel lines and concentric circles
  std::array<Vector2d, 2> points{Vector2d(0, 0), Vector2d(0, 0)};
};
[[nodiscard]] LocusCrossing crossLoci(const PositionLocus& a, const PositionLocus& b);
}  // namespace mrpt_ext
