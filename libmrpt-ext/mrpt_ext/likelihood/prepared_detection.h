#pragma once

#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// The part of a reading that all its detections and all robots share.
struct ScoringFrame
{
  Vector2d origin{0, 0};                          ///< [m] of the batch, in the map frame
  double sensor_height = 0;                       ///< [m]
  bool horizontal_range = false;                  ///< no slant
  Matrix2d sensor_covariance = Matrix2d::Zero();  ///< of the sensor position, axes of the sensor

  ScoringFrame(const Reading& reading, const Vector2d& batch_origin)
      : origin(batch_origin), sensor_height(reading.sensor_height), horizontal_range(reading.horizontal_range)
  {
    const Matrix2d R = rotation(-reading.T_robot_sensor.phi);
    sensor_covariance = R * reading.sensor_position_covariance * R.transpose();
  }
};

/// One detection associated with one landmark: all that does not depend on the robot, in single precision.
/// With e the clutter probability, s the expected share of the detection that is this landmark and V the volume of the
/// measurement space, the detection's likelihood is s (1 - e) N + s e / V summed over the landmarks it may show.
struct PreparedDetection
{
  float landmark_x, landmark_y;  ///< [m] from the origin
  float rise2;                   ///< [m^2] squared height of the landmark above the sensor
  float ray_x, ray_y;            ///< unit vector of the measured bearing, axes of the sensor
  float range;                   ///< [m] measured
  float bearing_factor;          ///< -log2(e) / (2 var_bearing): the Gaussian's exponent to base 2 per rad^2
  float range_factor;            ///< likewise per m^2
  float var_bearing, var_range;  ///< [rad^2], [m^2] of the sensor
  float map_xx, map_yy;          ///< [m^2] variance of the landmark's position
  float inlier_probability;      ///< 1 - e
  float peak;                    ///< (1 - e) times the largest density of N
  float floor = 0;               ///< e / V
};

/// Which components a detection has, and whether only the sensor's own noise counts.
struct DetectionKind
{
  bool bearing = false, range = false;
  bool sharp = false;  ///< constant variances, bearings to kSharpBearing or better
};

/// Standard deviation [rad] up to which 30 degrees are so far off that the exact figure makes no difference:
/// exp(-(0.5236 / 0.068)^2 / 2) = 1e-13.
inline constexpr double kSharpBearing = 0.068;

[[nodiscard]] inline DetectionKind detectionKind(const Detection& detection, const Landmark& landmark,
                                                 const ScoringFrame& frame)
{
  const bool constant = landmark.stddev.isZero(0) && frame.sensor_covariance.isZero(0);
  return {detection.bearing.has_value(), detection.range.has_value(),
          constant && (!detection.bearing || detection.std_bearing <= kSharpBearing)};
}

/// Not scaled and with floor 0, as for a detection that may show several landmarks. `clutter`: of the landmark, (0, 1].
[[nodiscard]] PreparedDetection prepareDetection(const Detection& detection, const Landmark& landmark, double clutter,
                                                 const ScoringFrame& frame);

/// (1 - e) times the largest density of N, from the sensor's noise alone.
[[nodiscard]] double peakOf(const Detection& detection, double clutter);
}  // namespace mrpt_ext
