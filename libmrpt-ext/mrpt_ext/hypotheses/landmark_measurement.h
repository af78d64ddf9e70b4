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
/// A detection with its sensor pose, ready for the solvers: slant range reduced to the plane, standard deviations
/// inflated by the uncertainty of the sensor position and of the landmark.
struct LandmarkMeasurement
{
  std::optional<std::size_t> landmark;  ///< index in the map; absent for an anonymous detection
  Vector2d position{0, 0};              ///< of that landmark, world frame [m]
  std::string category;                 ///< of the detection
  Pose2 T_robot_sensor;
  std::optional<double> bearing;                  ///< [rad]
  std::optional<double> range;                    ///< [m] horizontal
  double std_bearing = 0;                         ///< [rad]
  double std_range = 0;                           ///< [m]
  std::optional<Facing> headings = std::nullopt;  ///< of the robot in the world, if the landmark faces as seen

  [[nodiscard]] bool hasPoint() const { return bearing && range; }
  /// Position in the robot frame [m]; needs bearing and range.
  [[nodiscard]] Vector2d pointInRobot() const;
  [[nodiscard]] Matrix2d pointCovariance() const;
};

/// The identified detections of landmarks in the map. Slant ranges shorter than the difference in height are left out;
/// the bearing of such a detection is kept.
[[nodiscard]] std::vector<LandmarkMeasurement> identifiedMeasurements(std::span<const Reading> readings,
                                                                      const LandmarkTable& map);

/// The anonymous detections (with a category or without). Their slant ranges are reduced with the mean landmark height.
[[nodiscard]] std::vector<LandmarkMeasurement> anonymousMeasurements(std::span<const Reading> readings,
                                                                     const LandmarkTable& map);

/// One scalar measurement per bearing, per range and per heading that is certain (kCertainAttitude).
[[nodiscard]] std::vector<PoseMeasurement> poseMeasurements(std::span<const LandmarkMeasurement> measurements);

/// Reduces the slant ranges of a running fix to the plane; false if a range is shorter than the difference in height.
[[nodiscard]] bool reduceToHorizontal(RunningFixReading& fix, double landmark_height);

/// Number of different landmarks among the identified measurements that satisfy `counts`.
template <typename Predicate>
[[nodiscard]] std::size_t distinctLandmarks(std::span<const LandmarkMeasurement> measurements, Predicate&& counts)
{
  std::vector<std::size_t> found;
  for (const LandmarkMeasurement& m : measurements)
    if (m.landmark && counts(m) && std::find(found.begin(), found.end(), *m.landmark) == found.end())
      found.push_back(*m.landmark);
  return found.size();
}
}  // namespace mrpt_ext
