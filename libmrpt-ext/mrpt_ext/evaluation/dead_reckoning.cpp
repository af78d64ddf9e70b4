#include "mrpt_ext/evaluation/dead_reckoning.h"

#include <algorithm>
#include <limits>

namespace mrpt_ext
{
namespace
{
Pose2 poseAt(const Trajectory& odometry, double time)
{
  const double inside = std::clamp(time, odometry.front().time, odometry.back().time);
  return interpolate(odometry, inside, std::numeric_limits<double>::infinity())->pose;
}
}  // namespace

Pose2 motionBetween(const Trajectory& odometry, double from, double to)
{
  if (odometry.empty()) return {};
  return between(poseAt(odometry, from), poseAt(odometry, to));
}

PoseEstimate carry(const PoseEstimate& estimate, const Trajectory& odometry, double time)
{
  PoseEstimate carried = estimate;
  carried.time = time;
  if (!estimate.heading_known) return carried;
  carried.pose = compound(estimate.pose, motionBetween(odometry, estimate.time, time));
  return carried;
}
}  // namespace mrpt_ext
