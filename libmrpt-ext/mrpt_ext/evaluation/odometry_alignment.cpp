#include "mrpt_ext/evaluation/odometry_alignment.h"

#include "mrpt_ext/geometry/odometry_path.h"

namespace mrpt_ext
{
namespace
{
/// The poses up to the first at or after `end` [s].
Trajectory beginningOf(const MethodTrajectory& trajectory, double end)
{
  Trajectory beginning;
  for (const PoseEstimate& point : trajectory.points)
  {
    beginning.push_back({point.time, point.pose.mean, true});
    if (point.time >= end) break;
  }
  return beginning;
}

void turnCovariance(Matrix3d& covariance, double angle)
{
  Matrix3d R = Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = rotation(angle);
  covariance = R * covariance * R.transpose();
}
}  // namespace

bool alignWithTruth(MethodTrajectory& odometry, const Trajectory& truth)
{
  if (odometry.points.empty()) return false;
  const double begin = odometry.points.front().time, end = odometry.points.back().time;
  for (const TimedPose& anchor : truth)
  {
    if (!anchor.heading_known || anchor.time < begin || anchor.time > end) continue;
    const Pose2 first = odometry.points.front().pose.mean;
    const Pose2 then = compose(first, motionBetween(beginningOf(odometry, anchor.time), begin, anchor.time));
    const Pose2 T_map_own = compose(anchor.pose, inverse(then));
    DiskBackedSequence<PoseEstimate> aligned;
    for (PoseEstimate point : odometry.points)
    {
      point.pose.mean = compose(T_map_own, point.pose.mean);
      turnCovariance(point.pose.covariance, T_map_own.phi);
      aligned.push_back(point);
    }
    odometry.points = std::move(aligned);
    return true;
  }
  return false;
}

RunRecord withAlignedOdometry(RunRecord record, const Trajectory& truth)
{
  for (MethodTrajectory& method : record.methods)
    if (method.name == kOdometryMethod) static_cast<void>(alignWithTruth(method, truth));
  return record;
}
}  // namespace mrpt_ext
