#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/points/scan_points.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// Rigid motion of seen points onto landmarks, as a search needs it: no trigonometry, one deviation for all points.
struct PointFit
{
  double c = 1, s = 0;           ///< cosine and sine of the robot's heading
  Vector2d centre_robot{0, 0};   ///< mean of the matched points, robot frame [m]
  Vector2d centre_world{0, 0};   ///< mean of their landmarks [m]
  double position_variance = 0;  ///< of the mean, each axis [m^2]
  double heading_variance = 0;   ///< [rad^2]

  /// Where a point of the robot frame lies in the world.
  [[nodiscard]] Vector2d toWorld(const Vector2d& in_robot) const
  {
    const Vector2d d = in_robot - centre_robot;
    return {centre_world.x() + c * d.x() - s * d.y(), centre_world.y() + s * d.x() + c * d.y()};
  }
  /// Variance of that scan, the fit's part, in its worst direction [m^2].
  [[nodiscard]] double varianceAt(const Vector2d& in_robot) const
  {
    return position_variance + heading_variance * (in_robot - centre_robot).squaredNorm();
  }
  [[nodiscard]] GaussianPose pose() const;
};

/// A seen point and where its landmark is.
struct PointMatch
{
  const ScanPoint* point = nullptr;
  Vector2d landmark{0, 0};  ///< world frame [m]
};

/// Least-squares fit of two or more points.
[[nodiscard]] PointFit fitPoints(std::span<const PointMatch> matches);

/// Fit of a constellation that further points have joined.
struct GrownFit
{
  PointFit fit;
  int inliers = 0;  ///< points matched, the constellation's own included
};

/// Takes the other points one after the other: each that has a landmark of its category within `gate` standard
/// deviations of where the fit so far expects it joins the fit, which thereby becomes surer of the next. Stops when
/// `least` matches cannot be reached any more.
[[nodiscard]] GrownFit growFit(const LandmarkIndex& map, std::span<const PointMatch> constellation,
                               std::span<const ScanPoint> others, double gate, int least);
}  // namespace mrpt_ext
