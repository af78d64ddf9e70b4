#include "mrpt_ext/diagnosis/commanded_odometry.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mrpt_ext
{
namespace
{
constexpr double kSame = 0.01, kJump = 0.2;  // change of a velocity over the velocity
constexpr double kRest = 1e-6;               // [m/s], [rad/s]
constexpr std::size_t kLeastJumps = 20;

/// Change of a velocity over the larger of both; 0 at rest.
double relativeChange(const Vector2d& from, const Vector2d& to)
{
  double change = 0;
  for (int axis = 0; axis < 2; ++axis)
    if (const double larger = std::max(std::abs(from[axis]), std::abs(to[axis])); larger > kRest)
      change = std::max(change, std::abs(to[axis] - from[axis]) / larger);
  return change;
}
}  // namespace

bool isCommanded(const Trajectory& odometry)
{
  std::size_t same = 0, jumps = 0, others = 0;
  std::optional<Vector2d> before;  // speed and rate of turn
  for (std::size_t k = 1; k < odometry.size(); ++k)
  {
    const double seconds = odometry[k].time - odometry[k - 1].time;
    if (!(seconds > 0)) continue;
    const Pose2 moved = between(odometry[k - 1].pose, odometry[k].pose);
    const Vector2d velocity = Vector2d(moved.position().norm(), wrap(moved.phi)) / seconds;
    const bool rests = velocity.norm() <= kRest && (!before || before->norm() <= kRest);
    if (before && !rests)
    {
      const double change = relativeChange(*before, velocity);
      ++(change < kSame ? same : change > kJump ? jumps : others);
    }
    before = velocity;
  }
  return jumps >= kLeastJumps && same > jumps + others;
}

bool mayDrift(bool commanded, const LocalizationConfig& config)
{
  return !commanded || config.frames.odometry.turn_per_s != 0 ||
         std::any_of(config.biases.begin(), config.biases.end(),
                     [](const BiasState& bias) { return bias.kind == BiasKind::drift; });
}
}  // namespace mrpt_ext
