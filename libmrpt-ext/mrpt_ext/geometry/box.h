#pragma once

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Axis-aligned area in the world [m].
struct Box2
{
  Vector2d min{0, 0}, max{0, 0};

  [[nodiscard]] bool contains(const Vector2d& point, double margin = 0) const
  {
    return (point - min).minCoeff() >= -margin && (max - point).minCoeff() >= -margin;
  }
};
}  // namespace mrpt_ext
