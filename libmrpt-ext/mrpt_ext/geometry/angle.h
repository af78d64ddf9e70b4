#pragma once

#include <cmath>
#include <numbers>

namespace mrpt_ext
{
inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// Wraps an angle [rad] to (-pi, pi]. Non-finite input stays non-finite.
[[nodiscard]] inline double wrap(double angle)
{
  if (angle > -kPi && angle <= kPi) return angle;
  const double turned = angle - kTwoPi * std::floor((angle + kPi) / kTwoPi);
  return turned <= -kPi ? turned + kTwoPi : turned;
}

[[nodiscard]] constexpr double degToRad(double degrees) { return degrees * (kPi / 180.0); }
[[nodiscard]] constexpr double radToDeg(double radians) { return radians * (180.0 / kPi); }

[[nodiscard]] constexpr double square(double v) { return v * v; }
}  // namespace mrpt_ext
