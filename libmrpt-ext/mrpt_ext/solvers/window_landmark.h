#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/solvers/gaussian_point.h"

namespace mrpt_ext
{
/// One observation of a landmark within a window: a bearing, a range, or both.
struct WindowObservation
{
  Pose2 T_robot_sensor;  ///< pose of the sensor at that time, in the present robot frame
  Matrix3d odometry_covariance =
      Matrix3d::Zero();                   ///< of odometry since that time, as an error of the present pose (robot axes)
  std::optional<double> bearing;          ///< [rad, CCW from the sensor's forward axis]
  std::optional<double> range;            ///< [m, horizontal, from the sensor]
  double std_bearing = 0, std_range = 0;  ///< of the sensor alone; > 0 for what it measured
};

struct LocalizedLandmark
{
  GaussianPoint in_robot;  ///< present robot frame [m]
  double chi2 = 0;         ///< readings - 2 degrees of freedom
};

/// Position of one landmark relative to a robot that observed it once or several times while moving.
struct WindowLandmark
{
  SolveStatus status = SolveStatus::too_few;
  int readings = 0;                           ///< bearings and ranges counted
  std::vector<LocalizedLandmark> candidates;  ///< best first; two mirror images where the readings do not decide
};

/// Maximum-likelihood position of a landmark in the robot frame, observations oldest first; generalizes the
/// triangulation of paper 001 and the two ranges of paper 004 to any number and mix. Starts from pairs of all types:
/// bearing and range of one observation, two bearings, a bearing and a range, two ranges (both intersections, widest
/// pairs). Refined on all observations with the errors of odometry shared (window_noise.h); every minimum within
/// chi2 + 9 of the best is returned: ranges along a straight trajectory leave two mirror images, along a curved one a
/// single point. Where ranges leave the direction undetermined to first order (motion straight to or from the landmark)
/// the covariance is the spread over which the circles stay within their noise, as in runningFix. Status: `degenerate`
/// when the readings determine no point (one position without range, parallel bearings, a parallax within the noise:
/// standard deviation above half the distance, one range); `none` the lines of sight meet behind; `bad_input`.
[[nodiscard]] WindowLandmark locateLandmark(std::span<const WindowObservation> oldest_first);
}  // namespace mrpt_ext
