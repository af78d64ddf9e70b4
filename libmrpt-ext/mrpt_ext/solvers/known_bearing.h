#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/geometry/pose.h"
#include "mrpt_ext/geometry/solve_status.h"

namespace mrpt_ext
{
/// A bearing to a landmark that is identified.
struct KnownBearing
{
  Vector2d landmark{0, 0};  ///< world frame [m]
  double bearing = 0;       ///< [rad, CCW from the robot's forward axis], need not be wrapped
  double std = 1;           ///< [rad], > 0; the default weighs all alike and leaves covariances without meaning
};

/// What the closed forms need before they can start: `bad_input` (not finite, std <= 0), `too_few` (less than three),
/// `degenerate` (another landmark at the position of landmark 0), else `ok`.
[[nodiscard]] SolveStatus checkBearings(std::span<const KnownBearing> bearings);

/// Mean of the landmarks; iterations work relative to it, so that large map coordinates cost no digits.
[[nodiscard]] Vector2d landmarkMean(std::span<const KnownBearing> bearings);

/// Circular mean of the headings that the single bearings imply at `position`, weighted by 1 / variance.
[[nodiscard]] double meanHeading(std::span<const KnownBearing> bearings, const Vector2d& position);

/// Predicted minus measured bearing at `pose`, wrapped.
[[nodiscard]] std::vector<double> bearingResiduals(std::span<const KnownBearing> bearings, const Pose2& pose);
}  // namespace mrpt_ext
