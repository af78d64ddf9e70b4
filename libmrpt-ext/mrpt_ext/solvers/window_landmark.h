#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/solvers/gaussian_point.h"

namespace mrpt_ext
{
/// What a sensor saw of one landmark from one place of the way: a bearing, a range, or both.
struct WindowObservation
{
  Pose2 T_robot_sensor;  ///< the sensor's place then, in the robot frame of now
  Matrix3d odometry_covariance =
      Matrix3d::Zero();                   ///< of the way since, as an error of the robot's pose now (robot axes)
  std::optional<double> bearing;          ///< [rad, CCW from the sensor's forward axis]
  std::optional<double> range;            ///< [m, horizontal, from the sensor]
  double std_bearing = 0, std_range = 0;  ///< of the sensor alone, > 0 where it measured
};

struct LocalizedLandmark
{
  GaussianPoint in_robot;  ///< robot frame of now [m]
  double chi2 = 0;         ///< readings - 2 degrees of freedom
};

/// Where one landmark is, seen from a robot that saw it once or several times on its way.
struct WindowLandmark
{
  SolveStatus status = SolveStatus::too_few;
  int readings = 0;                       ///< bearings and ranges counted
  std::vector<LocalizedLandmark> places;  ///< best first; mirror images where the readings leave them
};

/// Maximum-likelihood place of a landmark in the robot frame, sightings oldest first; generalises the triangulation of
/// paper 001 and the two ranges of paper 004 to any number and mix. Started from every kind of pair: bearing and range
/// of one sighting, two bearings, a bearing and a range, two ranges (both intersections, widest pairs). Refined on all
/// sightings with the errors of odometry shared (window_noise.h); every minimum within chi2 + 9 of the best is
/// returned: ranges along a straight way leave two mirror images, along a bent way one place. Where ranges leave the
/// direction open to first order (the way leads to or from the landmark) the covariance is the spread over which the
/// circles stay within their noise, as in runningFix. Status: `degenerate` when the readings hold no point (one place
/// without range, parallel bearings, a parallax within the noise: deviation above half the distance, one range); `none`
/// the lines of sight meet behind; `bad_input`.
[[nodiscard]] WindowLandmark locateLandmark(std::span<const WindowObservation> oldest_first);
}  // namespace mrpt_ext
