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

TrackPoint carry(const TrackPoint& estimate, const Trajectory& odometry, double time)
{
  TrackPoint carried = estimate;
  carried.time = time;
  if (!estimate.heading_known) return carried;
  const Pose2 motion = motionBetween(odometry, estimate.time, time);
  const Matrix3d J = composeJacobianFirst(estimate.pose.mean, motion);
  carried.pose.mean = compose(estimate.pose.mean, motion);
  carried.pose.covariance = J * estimate.pose.covariance * J.transpose();
  return carried;
}
}  // namespace mrpt_ext
