#include "mrpt_ext/report/trajectory_tum.h"

#include "mrpt_ext/files/tum.h"

namespace mrpt_ext
{
Trajectory trajectoryOf(const MethodTrack& track)
{
  Trajectory trajectory;
  trajectory.reserve(track.points.size());
  for (const TrackPoint& point : track.points)
  {
    const TimedPose pose{point.time, point.pose.mean, point.heading_known};
    if (!trajectory.empty() && trajectory.back().time == pose.time)
      trajectory.back() = pose;
    else
      trajectory.push_back(pose);
  }
  return trajectory;
}

void writeTrajectoryTum(const std::filesystem::path& folder, const MethodTrack& track)
{
  writeTum(folder / ("trajectory_" + track.name + ".tum"), trajectoryOf(track));
}
}  // namespace mrpt_ext
