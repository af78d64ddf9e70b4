#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/solvers/pose_measurement.h"

namespace mrpt_ext
{
/// A detection with its sensor, ready for the solvers: slant range reduced to the plane, standard deviations grown by
/// what odometry and the map add.
struct LandmarkMeasurement
{
  std::optional<std::size_t> landmark;  ///< place in the map; absent for an unidentified detection
  Vector2d position{0, 0};              ///< of that landmark, world frame [m]
  std::string category;                 ///< of the detection
  Pose2 T_robot_sensor;
  std::optional<double> bearing;  ///< [rad]
  std::optional<double> range;    ///< [m] horizontal
  double std_bearing = 0;         ///< [rad]
  double std_range = 0;           ///< [m]

  [[nodiscard]] bool hasPoint() const { return bearing && range; }
  /// Where it is in the robot frame [m]; needs bearing and range.
  [[nodiscard]] Vector2d pointInRobot() const;
  [[nodiscard]] Matrix2d pointCovariance() const;
};

/// The identified detections whose landmark the map knows. Slant ranges shorter than the difference in height, which no
/// place explains, are left out; with a range that is left out, a bearing beside it is kept.
[[nodiscard]] std::vector<LandmarkMeasurement> identifiedSightings(std::span<const Reading> readings,
                                                                   const LandmarkTable& map);

/// The detections without id (category only, or nothing). Their slant ranges are reduced with the mean landmark height.
[[nodiscard]] std::vector<LandmarkMeasurement> unidentifiedSightings(std::span<const Reading> readings,
                                                                     const LandmarkTable& map);

/// One measurement row per bearing and per range of identified detections.
[[nodiscard]] std::vector<PoseMeasurement> poseMeasurements(std::span<const LandmarkMeasurement> seen);

/// Turns the slant ranges of a running fix into horizontal ones; false when a range is shorter than the height
/// difference.
[[nodiscard]] bool reduceToHorizontal(RunningFixReading& fix, double landmark_height);

/// Number of different landmarks among identified detections that satisfy `counts`.
template <typename Predicate>
[[nodiscard]] std::size_t distinctLandmarks(std::span<const LandmarkMeasurement> seen, Predicate&& counts)
{
  std::vector<std::size_t> found;
  for (const LandmarkMeasurement& s : seen)
    if (s.landmark && counts(s) && std::find(found.begin(), found.end(), *s.landmark) == found.end())
      found.push_back(*s.landmark);
  return found.size();
}
}  // namespace mrpt_ext
