#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
/// Which way a scanner turns, seen from above.
enum class SweepDirection
{
  counterclockwise,
  clockwise
};

/// The times at which a spinning scanner measures. The stamp of a scan is the time of its last beam. The beam turns
/// evenly through the field of view, from `start` to the other edge, within `duration`.
struct ScanSweep
{
  double duration = 0;  ///< [s] from the first beam to the last; 0: all at once
  SweepDirection direction = SweepDirection::counterclockwise;
  std::optional<double> start;  ///< [rad] bearing of the first beam; absent: the edge of the field of view

  /// How long before the stamp [s] a bearing [rad] was measured, with this field of view [rad].
  [[nodiscard]] double ageOf(double bearing, double field_of_view) const
  {
    const double sign = direction == SweepDirection::counterclockwise ? 1 : -1;
    double swept = sign * wrap(bearing) + field_of_view / 2;
    if (start)
    {
      swept = sign * wrap(bearing - *start);
      if (swept < 0) swept += kTwoPi;
    }
    return duration * (1 - std::clamp(swept / field_of_view, 0.0, 1.0));
  }
};
}  // namespace mrpt_ext
