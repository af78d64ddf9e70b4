#pragma once

#include "exact_scene.h"
#include "trajectory_scene.h"

namespace mrpt_ext
{
/// Readings of some landmarks at every pose of a trajectory, propagated to its end by exact odometry that states the
/// standard deviations `step_std` (x, y, phi) per step.
inline std::vector<Reading> windowOfReadings(const Pose2& end, const Pose2& step, int steps, const LandmarkTable& map,
                                             const std::vector<std::size_t>& landmarks, const ExactSensor& sensor,
                                             const Vector3d& step_std = {0.01, 0.01, 0.005})
{
  RandomStream unused(0);
  const DrivenTrajectory exact = driveSteps(end, step, steps, Vector3d::Zero(), unused),
                         stated = driveSteps(end, step, steps, step_std, unused);
  std::vector<Reading> readings;
  for (std::size_t k = 0; k < exact.poses.size(); ++k)
  {
    Reading reading = seenFrom(exact.true_poses[k], map, landmarks, sensor, static_cast<double>(k));
    reading.T_robot_sensor = compose(exact.poses[k], sensor.T_robot_sensor);
    reading.odometry_covariance = stated.covariances[k];
    for (Detection& d : reading.detections)
      if (d.bearing) d.std_bearing = std::hypot(d.std_bearing, std::sqrt(reading.odometry_covariance(2, 2)));
    readings.push_back(std::move(reading));
  }
  return readings;
}
}  // namespace mrpt_ext
