#pragma once

#include <vector>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Directions in which landmarks appear from within a small disc, for all landmarks at once.
class DirectionIntervals
{
 public:
  /// `middle` [m]: a point of the map, for precision.
  DirectionIntervals(const std::vector<Vector2d>& landmarks, const Vector2d& middle);

  /// From a disc of this radius [m] around `scan`: fills the arrays. Landmarks farther than `farthest` [m] are left
  /// out.
  void update(const Vector2d& scan, double radius, double farthest);

  /// [rad], within (-pi, pi], to 2e-6.
  [[nodiscard]] const std::vector<float>& direction() const { return direction_; }
  /// [rad] by which the direction can differ within the disc, rather too large; pi from a disc that contains the
  /// landmark; negative for a landmark that is left out.
  [[nodiscard]] const std::vector<float>& halfWidth() const { return half_width_; }

 private:
  Vector2d middle_;
  std::vector<float> x_, y_, direction_, half_width_;
};
}  // namespace mrpt_ext
