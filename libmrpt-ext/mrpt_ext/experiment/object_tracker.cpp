#include "mrpt_ext/experiment/object_tracker.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>

#include "mrpt_ext/hypotheses/landmark_measurement.h"
#include "mrpt_ext/solvers/object_position.h"
#include "mrpt_ext/solvers/omni_stereo.h"

namespace mrpt_ext
{
namespace
{
SightRay rayOf(const LandmarkMeasurement& s)
{
  return {s.T_robot_sensor.position(), s.T_robot_sensor.phi + *s.bearing, s.std_bearing};
}

/// Positions of the objects of one category in the robot frame.
std::vector<GaussianPoint> pointsInRobot(const std::vector<LandmarkMeasurement>& detections)
{
  std::vector<GaussianPoint> points;
  for (const LandmarkMeasurement& s : detections)
    if (s.hasPoint()) points.push_back({s.pointInRobot(), s.pointCovariance()});
  if (!points.empty()) return points;
  // Bearings only: one object seen by several sensors, triangulated by the best pair of them. Several objects of one
  // category cannot be distinguished.
  for (std::size_t i = 0; i < detections.size(); ++i)
    for (std::size_t j = i + 1; j < detections.size(); ++j)
    {
      if (detections[i].T_robot_sensor.position() == detections[j].T_robot_sensor.position()) continue;
      const Triangulation meeting = triangulate(rayOf(detections[i]), rayOf(detections[j]));
      if (meeting.status != SolveStatus::ok) continue;
      if (points.empty() || meeting.point.covariance.trace() < points.front().covariance.trace())
        points.assign(1, meeting.point);
    }
  return points;
}
}  // namespace

void ObjectTracker::add(std::vector<Frame> frames)
{
  std::move(frames.begin(), frames.end(), std::back_inserter(pending_));
}

void ObjectTracker::locate(const PoseEstimate& robot, DiskBackedSequence<ObjectRow>& rows)
{
  for (; !pending_.empty() && pending_.front().time <= robot.time; pending_.pop_front())
  {
    const Frame& frame = pending_.front();
    GaussianPose then = robot.pose;
    then.mean = compose(robot.pose.mean, odometry_.between(robot.time, frame.time).increment);
    std::map<std::string, std::vector<LandmarkMeasurement>> by_category;
    for (LandmarkMeasurement& s : anonymousMeasurements(frame.readings, LandmarkTable{}))
      by_category[s.category].push_back(std::move(s));
    for (const auto& [category, detections] : by_category)
      for (const GaussianPoint& seen : pointsInRobot(detections))
      {
        const GaussianPoint world = objectPosition(then, seen);
        rows.push_back({frame.time, category, world.mean, world.covariance, seen.mean});
      }
  }
}
}  // namespace mrpt_ext
