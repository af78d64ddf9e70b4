#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/geometry/measurement_jacobian.h"

namespace mrpt_ext
{
/// What a sensor without noise measures.
struct ExactSensor
{
  bool bearing = true, range = false, identified = true, category = false;
  Pose2 T_robot_sensor;
  double height = 0;
  double std_bearing = degToRad(0.5), std_range = 0.02;
};

/// A reading without noise of these landmarks (indices in the map) from `robot`.
inline Reading seenFrom(const Pose2& robot, const LandmarkTable& map, const std::vector<std::size_t>& landmarks,
                        const ExactSensor& sensor, double time = 0)
{
  Reading reading{
      .time = time, .sensor = "eye", .T_robot_sensor = sensor.T_robot_sensor, .sensor_height = sensor.height};
  reading.model.clutter_probability = 0.01;
  for (const std::size_t index : landmarks)
  {
    const Landmark& landmark = map[index];
    Detection d;
    if (sensor.identified) d.id = landmark.id;
    if (sensor.category) d.category = landmark.category;
    const Vector2d at = landmark.position.head<2>();
    if (sensor.bearing)
    {
      d.bearing = predictBearing(robot, at, sensor.T_robot_sensor);
      d.std_bearing = sensor.std_bearing;
    }
    if (sensor.range)
    {
      d.range = std::hypot(predictRange(robot, at, sensor.T_robot_sensor), landmark.position.z() - sensor.height);
      d.std_range = sensor.std_range;
    }
    reading.detections.push_back(d);
  }
  return reading;
}

inline double distance(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }
inline double turned(const Pose2& a, const Pose2& b) { return std::abs(wrap(a.phi - b.phi)); }

/// Five landmarks without symmetry, ids 1 ... 5.
inline LandmarkTable fiveLandmarks()
{
  return LandmarkTable({{.id = 1, .position = {0, 0, 0}, .category = "red"},
                        {.id = 2, .position = {6, 0.5, 0}, .category = "red"},
                        {.id = 3, .position = {5, 4, 0}, .category = "blue"},
                        {.id = 4, .position = {-1, 5, 0}, .category = "blue"},
                        {.id = 5, .position = {2, 7, 0}, .category = "red"}});
}
}  // namespace mrpt_ext
