#pragma once

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// Box of poses the robot may be in: position [m] and heading interval [rad] from phi_low over phi_span.
struct PoseRegion
{
  Vector2d low{0, 0}, high{0, 0};
  double phi_low = -kPi;
  double phi_span = kTwoPi;

  [[nodiscard]] bool contains(const Pose2& pose) const
  {
    const bool inside = pose.x >= low.x() && pose.x <= high.x() && pose.y >= low.y() && pose.y <= high.y();
    if (!inside || phi_span >= kTwoPi) return inside;
    const double turned = wrap(pose.phi - phi_low);
    return (turned < 0 ? turned + kTwoPi : turned) <= phi_span;
  }
  [[nodiscard]] double volume() const
  {
    return (high.x() - low.x()) * (high.y() - low.y()) * std::min(phi_span, kTwoPi);
  }
  /// Probability density [1/(m^2 rad)] of the uniform distribution over the region.
  [[nodiscard]] double density(const Pose2& pose) const { return contains(pose) ? 1 / volume() : 0.0; }
  [[nodiscard]] Pose2 sample(RandomStream& random) const
  {
    const double x = random.uniform(low.x(), high.x()), y = random.uniform(low.y(), high.y());
    return {x, y, wrap(phi_low + std::min(phi_span, kTwoPi) * random.uniform())};
  }
};
}  // namespace mrpt_ext
