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

/// Where the objects of one category are in the robot frame.
std::vector<GaussianPoint> pointsInRobot(const std::vector<LandmarkMeasurement>& sightings)
{
  std::vector<GaussianPoint> points;
  for (const LandmarkMeasurement& s : sightings)
    if (s.hasPoint()) points.push_back({s.pointInRobot(), s.pointCovariance()});
  if (!points.empty()) return points;
  // Bearings only: one object seen from several places, placed by the pair of sensors that sees it best. More sightings
  // of the kind cannot be told apart.
  for (std::size_t i = 0; i < sightings.size(); ++i)
    for (std::size_t j = i + 1; j < sightings.size(); ++j)
    {
      if (sightings[i].T_robot_sensor.position() == sightings[j].T_robot_sensor.position()) continue;
      const Triangulation meeting = triangulate(rayOf(sightings[i]), rayOf(sightings[j]));
      if (meeting.status != SolveStatus::ok) continue;
      if (points.empty() || meeting.point.covariance.trace() < points.front().covariance.trace())
        points.assign(1, meeting.point);
    }
  return points;
}
}  // namespace

void ObjectTracker::add(std::vector<Frame> sightings)
{
  std::move(sightings.begin(), sightings.end(), std::back_inserter(sightings_));
}

void ObjectTracker::place(const PoseEstimate& robot, DiskBackedSequence<ObjectRow>& rows)
{
  for (; !sightings_.empty() && sightings_.front().time <= robot.time; sightings_.pop_front())
  {
    const Frame& frame = sightings_.front();
    GaussianPose then = robot.pose;
    then.mean = compose(robot.pose.mean, odometry_.between(robot.time, frame.time).increment);
    std::map<std::string, std::vector<LandmarkMeasurement>> by_category;
    for (LandmarkMeasurement& s : unidentifiedSightings(frame.readings, LandmarkTable{}))
      by_category[s.category].push_back(std::move(s));
    for (const auto& [category, sightings] : by_category)
      for (const GaussianPoint& seen : pointsInRobot(sightings))
      {
        const GaussianPoint world = objectPosition(then, seen);
        rows.push_back({frame.time, category, world.mean, world.covariance, seen.mean});
      }
  }
}
}  // namespace mrpt_ext
