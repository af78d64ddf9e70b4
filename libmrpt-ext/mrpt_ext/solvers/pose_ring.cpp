#include "mrpt_ext/solvers/pose_ring.h"

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
PoseRing makePoseRing(const Vector2d& landmark, double range, double std_range, double bearing, double std_bearing,
                      const Pose2& T_robot_sensor)
{
  const Vector2d ray = direction(bearing + T_robot_sensor.phi);
  const Vector2d across = perpendicular(ray);
  PoseRing ring;
  ring.landmark = landmark;
  ring.seen_in_robot.mean = T_robot_sensor.position() + range * ray;
  ring.seen_in_robot.covariance =
      square(std_range) * ray * ray.transpose() + square(range * std_bearing) * across * across.transpose();
  return ring;
}

Pose2 poseOnRing(const PoseRing& ring, double heading)
{
  const Vector2d position = ring.landmark - rotation(heading) * ring.seen_in_robot.mean;
  return {position.x(), position.y(), wrap(heading)};
}

GaussianPose gaussianOnRing(const PoseRing& ring, double heading, double std_heading)
{
  const Matrix2d R = rotation(heading);
  const Vector2d turned = -perpendicular(R * ring.seen_in_robot.mean);  // d position / d heading
  return {poseOnRing(ring, heading),
          withHeading(R * ring.seen_in_robot.covariance * R.transpose(), turned, square(std_heading))};
}

std::vector<PoseOnRing> posesOnRing(const PoseRing& ring, const Facing& headings)
{
  std::vector<PoseOnRing> poses;
  for (const Facing::Attitude& heading : headings.attitudes)
    if (heading.weight > 0) poses.push_back({gaussianOnRing(ring, heading.yaw, heading.std), heading.weight});
  return poses;
}
}  // namespace mrpt_ext
