#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/points/scan_points.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// Rigid motion of detected points onto landmarks for the inner loop of a search: no trigonometry, one standard
/// deviation for all points.
struct PointFit
{
  double c = 1, s = 0;           ///< cosine and sine of the robot's heading
  Vector2d centre_robot{0, 0};   ///< mean of the matched points, robot frame [m]
  Vector2d centre_world{0, 0};   ///< mean of their landmarks [m]
  double position_variance = 0;  ///< of the mean, each axis [m^2]
  double heading_variance = 0;   ///< [rad^2]

  /// World position of a point of the robot frame.
  [[nodiscard]] Vector2d toWorld(const Vector2d& in_robot) const
  {
    const Vector2d d = in_robot - centre_robot;
    return {centre_world.x() + c * d.x() - s * d.y(), centre_world.y() + s * d.x() + c * d.y()};
  }
  /// Variance of that position due to the fit, in its worst direction [m^2].
  [[nodiscard]] double varianceAt(const Vector2d& in_robot) const
  {
    return position_variance + heading_variance * (in_robot - centre_robot).squaredNorm();
  }
  [[nodiscard]] GaussianPose pose() const;
};

/// A detected point and the position of its landmark.
struct PointMatch
{
  const ScanPoint* point = nullptr;
  Vector2d landmark{0, 0};  ///< world frame [m]
};

/// Least-squares fit of two or more points.
[[nodiscard]] PointFit fitPoints(std::span<const PointMatch> matches);

/// Fit of a constellation and the points added to it.
struct GrownFit
{
  PointFit fit;
  int inliers = 0;               ///< points matched, the constellation's own included
  std::uint64_t operations = 0;  ///< spent (geometry/work_budget.h)
};

/// Tries to add the other points one after the other: each with a landmark of its category within `gate` standard
/// deviations of its predicted position is added to the fit, which makes the next prediction more precise. Stops
/// when `least` inliers cannot be reached any more.
[[nodiscard]] GrownFit growFit(const LandmarkIndex& map, std::span<const PointMatch> constellation,
                               std::span<const ScanPoint> others, double gate, int least);
}  // namespace mrpt_ext
