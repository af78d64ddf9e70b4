#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/solvers/gaussian_point.h"

namespace mrpt_ext
{
/// Pose of a sensor at the time of a scan, by odometry.
struct ScanPose
{
  Pose2 T_robot_sensor;  ///< present robot frame
  Matrix3d odometry_covariance =
      Matrix3d::Zero();  ///< of odometry since that time, as an error of the present pose (robot axes)
};

/// One landmark of the local map, observed in one scan.
struct LandmarkObservation
{
  std::size_t scan = 0, landmark = 0;  ///< indices into `poses` and `start` of adjustBundle()
  std::optional<double> bearing;       ///< [rad, CCW from the sensor's forward axis]
  std::optional<double> range;         ///< [m, horizontal, from the sensor]
  double std_bearing = 0, std_range = 0;
};

struct BundleAdjustment
{
  SolveStatus status = SolveStatus::too_few;
  std::vector<GaussianPoint> landmarks;  ///< present robot frame [m]
  std::vector<ScanPose> poses;           ///< of the scans, corrected, with the covariance that remains
  std::vector<double> misfits;           ///< per observation: squared residuals over their expected variance
  double chi2 = 0;                       ///< of observations and odometry together
  int degrees = 0;
};

/// Bundle adjustment of a short window: maximum-likelihood positions of the landmarks and poses of the scans. All
/// observations of a scan share the error of its pose, so that the landmarks together determine the error of odometry
/// (points eliminated by their Schur complement). Directions become as precise as the sensor; odometry determines the
/// scale. Scans oldest first, the newest at the present pose; `start` in the present robot frame.
/// `robust`: observations beyond about three standard deviations have little weight (Cauchy), for associations that may
/// be wrong; the covariances then count each by its weight. Gauss-Newton; status `ok`, `too_few` (fewer readings than
/// unknowns), `degenerate` (a landmark without parallax), `bad_input` (an index out of range or a number that is not
/// finite).
[[nodiscard]] BundleAdjustment adjustBundle(std::span<const ScanPose> poses,
                                            std::span<const LandmarkObservation> observations,
                                            std::vector<Vector2d> start, bool robust = false);
}  // namespace mrpt_ext
