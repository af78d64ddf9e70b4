#include "mrpt_ext/diagnosis/link_noise.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/concatenated_motion.h"

namespace mrpt_ext
{
namespace
{
constexpr double kAside = 1.0;  // [s] before and after a motion that tell its noise
constexpr double kChord = 0.2;  // [s] of the path that is as good as a chord
}  // namespace

Pose2 LinkNoise::moved(double from, double to) const
{
  return nominalMotion(model_, {.increment = between(odometry_.at(from), odometry_.at(to))}).increment;
}

/// [rad] What noise turns is no turn.
double LinkNoise::turnBeyondNoise(const Pose2& moved, double duration) const
{
  const double turned = std::abs(moved.phi);
  const OdometryMotion motion{
      .increment = moved, .path_length = moved.position().norm(), .turned = turned, .duration = duration};
  return std::sqrt(std::max(square(turned) - square(incrementStd(model_, motion).z()), 0.0));
}

PerMotionNoise<Matrix3d> LinkNoise::covariances(double from, double to) const
{
  const double aside = std::max(to - from, kAside);
  const Pose2 before = moved(from - aside, from), after = moved(to, to + aside);
  const double way = before.position().norm() + after.position().norm();
  const double turn = turnBeyondNoise(before, aside) + turnBeyondNoise(after, aside);
  // The shape of the path is its own: it tells which way an error of the heading leads.
  const double steps = std::max(1.0, std::ceil((to - from) / kChord - 1e-6)), lasts = (to - from) / steps;
  const double share = lasts / (2 * aside);
  OdometryMotion whole;
  for (double k = 0; k < steps; ++k)
  {
    const Pose2 increment = moved(from + k * lasts, from + (k + 1) * lasts);
    whole = concatenated(
        whole, {.increment = increment, .path_length = share * way, .turned = share * turn, .duration = lasts});
  }
  const auto [position, by_turning, by_way, by_time] = covarianceBySource(model_, whole);
  return {position, by_turning + by_way + by_time};
}
}  // namespace mrpt_ext
