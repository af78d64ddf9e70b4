#pragma once

#include <cmath>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// To the nearest millionth. The last bits of sin, cos and log differ between machines; written values must not.
[[nodiscard]] inline double rounded(double value) { return std::round(value * 1e6) / 1e6; }

[[nodiscard]] inline double roundedAngle(double angle) { return wrap(rounded(wrap(angle))); }

[[nodiscard]] inline Pose2 rounded(const Pose2& pose)
{
  return {rounded(pose.x), rounded(pose.y), roundedAngle(pose.phi)};
}
}  // namespace mrpt_ext
