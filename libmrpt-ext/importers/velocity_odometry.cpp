#include "mrpt_ext/importers/velocity_odometry.h"

#include <cmath>

namespace mrpt_ext
{
Pose2 arcMotion(double forward, double angular, double duration)
{
  const double length = forward * duration, turn = angular * duration;
  // The chord points along half the turn and is shorter than the arc by sin(h)/h.
  const double half = turn / 2;
  const double chord = length * (std::abs(half) < 1e-4 ? 1 - half * half / 6 : std::sin(half) / half);
  return {chord * std::cos(half), chord * std::sin(half), wrap(turn)};
}

std::vector<OdometryRecord> integrateVelocities(const std::vector<VelocityRecord>& velocities)
{
  std::vector<OdometryRecord> odometry;
  odometry.reserve(velocities.size());
  Pose2 pose;
  for (std::size_t i = 0; i < velocities.size(); ++i)
  {
    if (i > 0)
    {
      const VelocityRecord& before = velocities[i - 1];
      pose = compose(pose, arcMotion(before.forward, before.angular, velocities[i].time - before.time));
      if (velocities[i].time == before.time) continue;
    }
    odometry.push_back({velocities[i].time, pose});
  }
  return odometry;
}
}  // namespace mrpt_ext
