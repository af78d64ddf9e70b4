#pragma once

#include "exact_scene.h"
#include "trajectory_scene.h"

namespace mrpt_ext
{
/// What a robot sees of some landmarks from every place of a way, as carried to its end by odometry, which says exactly
/// how it went and claims to err by `step_std` (x, y, phi) per step.
inline std::vector<Reading> seenAlong(const Pose2& end, const Pose2& step, int steps, const LandmarkTable& map,
                                      const std::vector<std::size_t>& landmarks, const ExactSensor& sensor,
                                      const Vector3d& step_std = {0.01, 0.01, 0.005})
{
  RandomStream unused(0);
  const Way exact = makeWay(end, step, steps, Vector3d::Zero(), unused),
            claimed = makeWay(end, step, steps, step_std, unused);
  std::vector<Reading> readings;
  for (std::size_t k = 0; k < exact.places.size(); ++k)
  {
    Reading reading = seenFrom(exact.true_places[k], map, landmarks, sensor, static_cast<double>(k));
    reading.T_robot_sensor = compose(exact.places[k], sensor.T_robot_sensor);
    reading.odometry_covariance = claimed.covariances[k];
    for (Detection& d : reading.detections)
      if (d.bearing) d.std_bearing = std::hypot(d.std_bearing, std::sqrt(reading.odometry_covariance(2, 2)));
    readings.push_back(std::move(reading));
  }
  return readings;
}
}  // namespace mrpt_ext
