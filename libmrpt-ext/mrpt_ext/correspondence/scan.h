#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
inline constexpr int kAnyCategory = -1;      ///< the sensor does not report a category
inline constexpr int kUnknownCategory = -2;  ///< a category that no landmark of the map has: a false detection

/// A detection without identity: a bearing, a range (horizontal), or both.
struct AnonymousDetection
{
  std::optional<double> bearing;  ///< [rad, CCW from the sensor's forward axis]
  std::optional<double> range;    ///< [m, horizontal, from the sensor]
  double std_bearing = 0;         ///< [rad]
  double std_range = 0;           ///< [m]
  int category = kAnyCategory;    ///< as numbered by LandmarkIndex::categoryOf()
};

/// All detections of one sensor at one time. Each landmark appears at most once among them.
struct Scan
{
  Pose2 T_robot_sensor;  ///< for a past scan: in the present robot frame
  SensorModel model;     ///< no range limit: unlimited; no detection probability: missed detections do not count
  std::vector<AnonymousDetection> detections;
};

/// Number of detections of all scans together.
[[nodiscard]] inline std::size_t detectionCount(std::span<const Scan> scans)
{
  std::size_t count = 0;
  for (const Scan& scan : scans) count += scan.detections.size();
  return count;
}

/// Number of those that have both bearing and range.
[[nodiscard]] inline std::size_t pointCount(std::span<const Scan> scans)
{
  std::size_t count = 0;
  for (const Scan& scan : scans)
    for (const AnonymousDetection& detection : scan.detections) count += detection.bearing && detection.range ? 1 : 0;
  return count;
}
}  // namespace mrpt_ext
