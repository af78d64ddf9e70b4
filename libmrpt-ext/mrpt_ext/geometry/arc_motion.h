#pragma once

#include <cmath>

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Motion during `duration` [s] at constant `forward` [m/s] and `angular` [rad/s] velocity: exactly the arc, end pose
/// in the frame of the start.
[[nodiscard]] inline Pose2 arcMotion(double forward, double angular, double duration)
{
  const double turn = angular * duration, arc = forward * duration;
  // The chord points along half the turn and is shorter than the arc by sin(h)/h.
  const double half = 0.5 * turn;
  const double chord = std::abs(half) < 1e-6 ? arc * (1 - half * half / 6) : arc * std::sin(half) / half;
  return {chord * std::cos(half), chord * std::sin(half), wrap(turn)};
}
}  // namespace mrpt_ext
