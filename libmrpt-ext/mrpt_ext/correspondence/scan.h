#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
inline constexpr int kAnyCategory = -1;      ///< the sensor cannot tell what category of landmark it saw
inline constexpr int kUnknownCategory = -2;  ///< a category that the map has no landmark of: surely false

/// A feature that the sensor saw but could not name: a bearing, a range (horizontal), or both.
struct AnonymousDetection
{
  std::optional<double> bearing;  ///< [rad, CCW from the sensor's forward axis]
  std::optional<double> range;    ///< [m, horizontal, from the sensor]
  double std_bearing = 0;         ///< [rad]
  double std_range = 0;           ///< [m]
  int category = kAnyCategory;    ///< LandmarkIndex::categoryOf its category
};

/// All that one sensor saw from one scan on the robot, or, carried along by odometry, from a scan it has passed.
/// Every landmark appears at most once among the detections of a scan.
struct Scan
{
  Pose2 T_robot_sensor;
  SensorModel model;  ///< a missing range limit means: sees everything; a missing detection probability: scores no gap
  std::vector<AnonymousDetection> detections;
};

/// Number of detections of all scans together.
[[nodiscard]] inline std::size_t detectionCount(std::span<const Scan> scans)
{
  std::size_t count = 0;
  for (const Scan& scan : scans) count += scan.detections.size();
  return count;
}
}  // namespace mrpt_ext
