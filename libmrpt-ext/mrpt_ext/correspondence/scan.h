#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
inline constexpr int kAnyCategory = -1;      ///< the sensor cannot tell what kind of landmark it saw
inline constexpr int kUnknownCategory = -2;  ///< a kind that the map has no landmark of: surely false

/// A feature that the sensor saw but could not name: a bearing, a range (horizontal), or both.
struct AnonymousDetection
{
  std::optional<double> bearing;  ///< [rad, CCW from the sensor's forward axis]
  std::optional<double> range;    ///< [m, horizontal, from the sensor]
  double std_bearing = 0;         ///< [rad]
  double std_range = 0;           ///< [m]
  int kind = kAnyCategory;        ///< LandmarkIndex::kindOf its category
};

/// All that one sensor saw from one place on the robot, or, carried along by odometry, from a place it has passed.
/// Every landmark appears at most once among the detections of a place.
struct Scan
{
  Pose2 T_robot_sensor;
  SensorModel model;  ///< a missing range limit means: sees everything; a missing detection probability: scores no gap
  std::vector<AnonymousDetection> detections;
};

/// Number of detections of all places together.
[[nodiscard]] inline std::size_t detectionCount(std::span<const Scan> places)
{
  std::size_t count = 0;
  for (const Scan& place : places) count += place.detections.size();
  return count;
}
}  // namespace mrpt_ext
