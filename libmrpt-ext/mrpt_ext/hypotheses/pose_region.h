#pragma once

#include <algorithm>

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// Box of possible poses: position [m] and the heading interval [phi_low, phi_low + phi_span] [rad].
/// A side without extent counts as kMinExtent wide, so that the density exists.
struct PoseRegion
{
  static constexpr double kMinExtent = 1e-3;  ///< [m] and [rad]

  Vector2d low{0, 0}, high{0, 0};
  double phi_low = -kPi;
  double phi_span = kTwoPi;

  [[nodiscard]] Vector2d extent() const { return (high - low).cwiseMax(kMinExtent); }
  [[nodiscard]] double headingExtent() const { return std::clamp(phi_span, kMinExtent, kTwoPi); }
  [[nodiscard]] bool contains(const Pose2& pose) const
  {
    const Vector2d top = low + extent();
    const bool inside = pose.x >= low.x() && pose.x <= top.x() && pose.y >= low.y() && pose.y <= top.y();
    if (!inside || phi_span >= kTwoPi) return inside;
    const double turned = wrap(pose.phi - phi_low);
    return (turned < 0 ? turned + kTwoPi : turned) <= headingExtent();
  }
  [[nodiscard]] double volume() const { return extent().prod() * headingExtent(); }
  /// Probability density [1/(m^2 rad)] of the uniform distribution over the region.
  [[nodiscard]] double density(const Pose2& pose) const { return contains(pose) ? 1 / volume() : 0.0; }
  [[nodiscard]] Pose2 sample(RandomStream& random) const
  {
    const double x = low.x() + extent().x() * random.uniform(), y = low.y() + extent().y() * random.uniform();
    return {x, y, wrap(phi_low + headingExtent() * random.uniform())};
  }
};
}  // namespace mrpt_ext
