#pragma once

#include <vector>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Interval of directions in which each landmark appears from anywhere in a small disc, for all landmarks at once.
class DirectionIntervals
{
 public:
  /// `middle` [m]: a point of the map, for precision.
  DirectionIntervals(const std::vector<Vector2d>& landmarks, const Vector2d& middle);

  /// Fills the arrays for the disc of this radius [m] around `centre`, without landmarks farther than `farthest`
  /// [m].
  void update(const Vector2d& centre, double radius, double farthest);

  /// [rad], within (-pi, pi], to 2e-6.
  [[nodiscard]] const std::vector<float>& direction() const { return direction_; }
  /// [rad] half the interval, rather too large; pi if the disc contains the landmark; negative for one that is
  /// left out.
  [[nodiscard]] const std::vector<float>& halfWidth() const { return half_width_; }

 private:
  Vector2d middle_;
  std::vector<float> x_, y_, direction_, half_width_;
};
}  // namespace mrpt_ext
