#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/solvers/gaussian_point.h"

namespace mrpt_ext
{
/// A horizontal range to a known landmark (slant ranges: sqrt(r^2 - dz^2) first).
struct KnownRange
{
  Vector2d landmark{0, 0};  ///< world frame [m]
  double range = 0;         ///< [m], >= 0
  double std = 1;           ///< [m], > 0
};

struct RangePosition
{
  GaussianPoint position;         ///< of the sensor; the heading stays open
  double chi2 = 0;                ///< sum of squared residuals / variances
  std::vector<double> residuals;  ///< predicted minus measured [m], one per given range
};

struct RangePositions
{
  SolveStatus status = SolveStatus::too_few;
  std::vector<RangePosition> candidates;  ///< best first; two when the ranges leave a mirror image
};

/// Maximum-likelihood position from two or more ranges: guarded Levenberg-Marquardt from the linear least squares of
/// the differences of the squared ranges and from the two circles of the best-placed pair. Mirror images are both
/// returned (two ranges, or landmarks on one line), as is a second minimum that fits within chi2 + 9 of the best.
/// Two circles that miss each other give the midpoint of their gap. Covariance: inverse Fisher information, or, where
/// the sensor is in line with the landmarks, the ring width of the worst range along the undetermined direction.
/// Status: `degenerate` when all landmarks have the same position, `too_few` below two ranges, `bad_input`.
[[nodiscard]] RangePositions solveRangePosition(std::span<const KnownRange> ranges);
}  // namespace mrpt_ext
