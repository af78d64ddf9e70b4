#pragma once

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// z component of the cross product: positive when `b` is counter-clockwise of `a`.
[[nodiscard]] inline double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// `v` turned by +90 degrees.
[[nodiscard]] inline Vector2d perpendicular(const Vector2d& v) { return {-v.y(), v.x()}; }

/// Unit vector in the direction `angle` [rad].
[[nodiscard]] inline Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Direction angle of `v` [rad].
[[nodiscard]] inline double angleOf(const Vector2d& v) { return std::atan2(v.y(), v.x()); }
}  // namespace mrpt_ext
