#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/calibration/motion_noise.h"
#include "mrpt_ext/geometry/odometry_path.h"

namespace mrpt_ext
{
/// Systematic errors of a recording, the parameters of its calibration.
enum class CalibrationParameter
{
  delay,           ///< [s] how old a reading of the sensor is at its stamp, by the clock of odometry
  lever_arm_x,     ///< [m] true minus stated position of the sensor on the robot, forward
  lever_arm_y,     ///< [m] the same to the left
  bearing_offset,  ///< [rad] measured = (1 + scale) true + offset
  bearing_scale,   ///< of a sensor that looks ahead: a focal length that is not exact
  range_offset,    ///< [m] measured = (1 + scale) true + offset
  range_scale,
  range_axis,       ///< [rad] logged bearing of the axis that ranges are depths along, beyond the configured one
  landmark_offset,  ///< [m] offset of the ranges of one landmark, on top of range_offset: radios have a delay of their
                    ///< own
  landmark_x,       ///< [m] true minus stated position of a landmark in the map, along its x axis
  landmark_y,       ///< [m] the same along its y axis
  range_height,     ///< [m^2] measured^2 = true^2 + this: the squared height that map and sensor do not state
  distance_scale,   ///< true distance = (1 + scale) (distance by odometry + distance_per_turn * turn on arcs)
  distance_per_turn,  ///< [m/rad] of turn to either side while the robot drives
  rotation_scale,     ///< true rotation = (1 + scale) rotation by odometry + veer * distance + drift * time
  pivot_scale,        ///< true rotation in place = (1 + scale + this) rotation by odometry
  veer,               ///< [rad/m] to the left
  drift               ///< [rad/s] to the left
};

/// True for the errors of odometry; the others belong to a sensor.
[[nodiscard]] constexpr bool isOfOdometry(CalibrationParameter parameter)
{
  return parameter >= CalibrationParameter::distance_scale;
}

/// True for what all ranges of a sensor share: offset and scale, which are only told together.
[[nodiscard]] constexpr bool isOfAllRanges(CalibrationParameter parameter)
{
  return parameter == CalibrationParameter::range_offset || parameter == CalibrationParameter::range_scale;
}

/// True for what all distances by odometry share, and those on arcs: which of them errs is told where both are driven.
[[nodiscard]] constexpr bool isOfDistances(CalibrationParameter parameter)
{
  return parameter == CalibrationParameter::distance_scale || parameter == CalibrationParameter::distance_per_turn;
}

/// True for an error of odometry in one regime of motion, beside that of all.
[[nodiscard]] constexpr bool isOfRegime(CalibrationParameter parameter)
{
  return parameter == CalibrationParameter::distance_per_turn || parameter == CalibrationParameter::pivot_scale;
}

[[nodiscard]] constexpr bool isLeverArm(CalibrationParameter parameter)
{
  return parameter == CalibrationParameter::lever_arm_x || parameter == CalibrationParameter::lever_arm_y;
}

/// True for a coordinate of one landmark: an error of the map, whatever sensor sees it.
[[nodiscard]] constexpr bool isOfMap(CalibrationParameter parameter)
{
  return parameter == CalibrationParameter::landmark_x || parameter == CalibrationParameter::landmark_y;
}

/// True for what each landmark has by itself.
[[nodiscard]] constexpr bool isOfLandmark(CalibrationParameter parameter)
{
  return parameter == CalibrationParameter::landmark_offset || isOfMap(parameter);
}

/// A parameter to estimate; the sensor counts for parameters of a sensor only, the landmark for those of one. Errors of
/// the map carry the sensor that tells them.
struct CalibrationUnknown
{
  CalibrationParameter parameter = CalibrationParameter::delay;
  std::size_t sensor = 0;
  std::size_t landmark = 0;  ///< its number
};

/// One number that a sensor measured of a known landmark.
struct CalibrationReading
{
  std::size_t pose = 0;             ///< number of the pose of its stamp
  std::size_t sensor = 0;           ///< number of the sensor
  bool is_range = false;            ///< else a bearing
  Vector2d landmark{0, 0};          ///< [m], world frame
  std::size_t landmark_number = 0;  ///< in the map
  Pose2 T_robot_sensor;             ///< at the stamp
  double height = 0;                ///< [m] of the landmark above the sensor; 0 for horizontal ranges
  double value = 0;                 ///< [rad] or [m]
  double std = 0;                   ///< likewise, as declared
  /// [rad] Of a range with a bearing: how far left of the axis that depths are measured along, as logged.
  std::optional<double> off_axis = std::nullopt;
};

/// A pose of the trajectory, first guess.
struct TrajectoryPose
{
  double time = 0;  ///< [s]
  Pose2 pose;
  /// Covariances of the increment of odometry since the pose before it, as declared, by what errs, in axes of that
  /// pose; absent: not tied to it.
  std::optional<PerMotionNoise<Matrix3d>> since_previous;
};

/// A recording with poses that are roughly known.
struct CalibrationProblem
{
  std::vector<TrajectoryPose> poses;         ///< ordered by time
  std::vector<CalibrationReading> readings;  ///< ordered by pose
  std::vector<OdometryRecord> odometry;      ///< empty: the poses drift by `since_previous` alone
  std::size_t sensors = 0;
  std::vector<double> known_delays;   ///< [s] of each sensor: its poses are that much before its stamps; absent: 0
  std::vector<double> lever_arm_std;  ///< [m] of each sensor's stated position, along each axis; absent: 0.05
};

inline constexpr double kOutlierMisfit = 4;  ///< standard deviations beyond which a residual is an outlier's

/// Scatter of the residuals of one sensor.
struct SensorScatter
{
  double bearing = 1, range = 1;  ///< over the declared standard deviation
  std::size_t bearings = 0, ranges = 0;
  /// Number of residuals less what the adjustment took up: the information about the scatter.
  double bearing_redundancy = 0, range_redundancy = 0;
  double bearing_taken_up = 0, range_taken_up = 0;  ///< number that the adjustment took up; neither counts outliers
  double landmark_offset_std = 0;                   ///< [m] by which its landmarks' offsets differ; 0: none to estimate
  double landmark_place_std = 0;  ///< [m] by which they stand beside their places in the map, along each axis; likewise
};
}  // namespace mrpt_ext
