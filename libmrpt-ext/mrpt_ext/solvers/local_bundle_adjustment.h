#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/solvers/gaussian_point.h"

namespace mrpt_ext
{
/// Where a sensor was when it looked, as odometry tells it from now.
struct ScanPose
{
  Pose2 T_robot_sensor;  ///< robot frame of now
  Matrix3d odometry_covariance =
      Matrix3d::Zero();  ///< of the way since, as an error of the robot's pose now (robot axes)
};

/// One of the landmarks of the constellation, seen from one of the places.
struct LandmarkObservation
{
  std::size_t place = 0, landmark = 0;
  std::optional<double> bearing;  ///< [rad, CCW from the sensor's forward axis]
  std::optional<double> range;    ///< [m, horizontal, from the sensor]
  double std_bearing = 0, std_range = 0;
};

struct BundleAdjustment
{
  SolveStatus status = SolveStatus::too_few;
  std::vector<GaussianPoint> landmarks;  ///< robot frame of now [m]
  std::vector<ScanPose> places;          ///< corrected, with what remains of their covariance
  std::vector<double> misfits;           ///< of each sighting: squared residuals over the variance they should have
  double chi2 = 0;                       ///< of sightings and odometry together
  int degrees = 0;
};

/// Maximum-likelihood constellation of landmarks seen along a short way, and the way itself: all that was seen from a
/// place shares the error of its place, so the landmarks together tell how odometry erred (bundle adjustment, points
/// eliminated by their Schur complement). Directions become as sharp as the sensor; odometry keeps the scale. Places
/// oldest first, the newest sightings from where the robot is now; `start` in the robot frame of now.
/// `robust`: sightings beyond about three deviations hardly pull (Cauchy), for associations that may be wrong; the
/// covariances then count each by its weight. Gauss-Newton; status `ok`, `too_few` (fewer readings than unknowns),
/// `degenerate` (a landmark without parallax), `bad_input` (an index out of range or a number that is not finite).
[[nodiscard]] BundleAdjustment adjustBundle(std::span<const ScanPose> places,
                                            std::span<const LandmarkObservation> sightings, std::vector<Vector2d> start,
                                            bool robust = false);
}  // namespace mrpt_ext
