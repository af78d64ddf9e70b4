#include "mrpt_ext/importers/velocity_odometry.h"

namespace mrpt_ext
{
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
