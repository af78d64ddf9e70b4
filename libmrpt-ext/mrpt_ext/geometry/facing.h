#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
/// The direction in which a seen feature faces, that of its normal (a flat tag faces those who can read it), as one
/// sensor measures it: a mixture of two Gaussians, because of a far tag two attitudes explain the image.
struct Facing
{
  struct Attitude
  {
    double yaw = 0;     ///< [rad] of the normal, CCW from the sensor's forward axis
    double std = 0;     ///< [rad]
    double weight = 0;  ///< probability; both together 1
  };
  std::array<Attitude, 2> attitudes{};  ///< likelier first; the weight of the second is 0 where there is only one

  /// One attitude.
  [[nodiscard]] static Facing single(double yaw, double std) { return {{{{wrap(yaw), std, 1}, {}}}}; }
  /// Two, of which `other_weight` in [0, 1] is the probability of the second; sorted by probability.
  [[nodiscard]] static Facing either(const Attitude& one, const Attitude& other, double other_weight)
  {
    const Attitude a{wrap(one.yaw), one.std, 1 - other_weight}, b{wrap(other.yaw), other.std, other_weight};
    return other_weight > 0.5 ? Facing{{{b, a}}} : Facing{{{a, b}}};
  }
};

/// Probability from which on an attitude counts as the only one where no mixture can be used: of a hundred such
/// measurements one may be of the other.
inline constexpr double kCertainAttitude = 0.99;

/// Seen from axes that are turned by `angle` [rad] against the sensor's.
[[nodiscard]] inline Facing turnedBack(Facing facing, double angle)
{
  for (Facing::Attitude& attitude : facing.attitudes) attitude.yaw = wrap(attitude.yaw - angle);
  return facing;
}

/// With an independent error of this variance [rad^2] added. Negative: taken off, down to a floor that guards against
/// cancellation.
[[nodiscard]] inline Facing widened(Facing facing, double variance)
{
  constexpr double kFloor = 1e-9;  // relative
  for (Facing::Attitude& attitude : facing.attitudes)
    attitude.std = std::sqrt(std::max(square(attitude.std) + variance, kFloor * square(attitude.std)));
  return facing;
}
}  // namespace mrpt_ext
