#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/geometry/facing.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// One detected feature: a bearing, a range, or both, identified or anonymous.
struct Detection
{
  int id = kNoId;                 ///< landmark id, kNoId when unknown
  std::string category;           ///< of the landmark, empty when unknown
  std::optional<double> bearing;  ///< [rad] CCW from the sensor's forward axis
  std::optional<double> range;    ///< [m] from the sensor origin
  double std_bearing = 0;         ///< [rad], meaningful with a bearing
  double std_range = 0;           ///< [m], meaningful with a range
  /// Which way the landmark faces; only of identified detections it says something about the robot.
  std::optional<Facing> facing = std::nullopt;
};

/// [m] Assumed standard deviation of a sensor's position on the robot, where none is given.
inline constexpr double kAssumedLeverArmStd = 0.05;

/// What the likelihood needs to know about a sensor.
struct SensorModel
{
  double field_of_view = kTwoPi;                ///< [rad], full angle, centred on the forward axis
  std::optional<double> max_range;              ///< [m]
  double clutter_probability = 0.05;            ///< share of detections that come from no mapped landmark
  std::optional<double> detection_probability;  ///< of a landmark in view; absent: missed detections are not scored
  bool has_field_of_view = false;               ///< true when declared by the log or the configuration
  std::optional<double> lever_arm_std;          ///< [m] of the stated position on the robot, along each axis, if given
  double yaw_std = 0;                           ///< [rad] of the stated direction on the robot
  double delay_std = 0.05;                      ///< [s] of the times of its readings, all alike
};

/// The detections of one sensor at one time.
struct Reading
{
  double time = 0;                ///< [s] of the measurement, corrected for the delay of the sensor
  std::string sensor;             ///< label, never empty
  Pose2 T_robot_sensor;           ///< sensor pose in the robot frame *of the frame the reading belongs to*
  double sensor_height = 0;       ///< [m] above the floor, for slant ranges
  bool horizontal_range = false;  ///< ranges are measured in the plane, not as a slant
  /// Of the sensor position that odometry moved to the time of the frame, in robot axes.
  Matrix2d sensor_position_covariance = Matrix2d::Zero();
  /// Of the odometry from `time` to the time of the frame: order (x, y, phi), axes of the robot at the latter; zero
  /// without motion between them. `sensor_position_covariance` and the standard deviations of the bearings contain it
  /// already, each for itself; here it stands as the error that measurements of one time share.
  Matrix3d odometry_covariance = Matrix3d::Zero();
  SensorModel model;
  std::vector<Detection> detections;
};

/// Two ranges to one landmark from two poses (paper 004), as logged by CObservationRunningFix.
struct RunningFixReading
{
  double time = 0;        ///< [s] of the second range
  double first_time = 0;  ///< [s] of the first range
  std::string sensor;
  Pose2 T_robot_sensor;
  double sensor_height = 0;
  bool horizontal_range = false;
  SensorModel model;
  int id = kNoId;
  double first_range = 0, first_std = 0;    ///< [m]
  double second_range = 0, second_std = 0;  ///< [m]
  Pose2 displacement;                       ///< second robot pose in the frame of the first
  Matrix3d displacement_covariance = Matrix3d::Zero();
  std::optional<double> second_bearing;  ///< [rad] at the second pose
  double second_bearing_std = 0;
  bool ranges_logged_too = false;  ///< its ranges are in the log as well: propose from it, do not score it
};

/// True when some detection is anonymous.
[[nodiscard]] inline bool hasAnonymous(const Reading& reading)
{
  return std::any_of(reading.detections.begin(), reading.detections.end(),
                     [](const Detection& d) { return d.id == kNoId; });
}
}  // namespace mrpt_ext
