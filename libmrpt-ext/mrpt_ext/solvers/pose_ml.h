#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/solvers/levenberg_marquardt.h"
#include "mrpt_ext/solvers/pose_measurement.h"

namespace mrpt_ext
{
/// Influence of large residuals. With e = residual / std:
enum class Loss
{
  squared,  ///< e^2: maximum likelihood under Gaussian noise
  cauchy    ///< k^2 log(1 + e^2 / k^2), k = 2: gross errors have little weight
};

struct PoseMl
{
  SolveStatus status = SolveStatus::too_few;
  GaussianPose pose;              ///< covariance = inverse Fisher information; set only when status is ok
  double chi2 = 0;                ///< sum of squared residuals / variances (sum of the losses with a robust loss)
  double start_chi2 = 0;          ///< the same at the start pose, never smaller
  double det_ratio = 0;           ///< informationRatio at the solution, in [0, 1]: quality of the geometry
  std::vector<double> residuals;  ///< predicted minus measured, in the measurements' units
  int iterations = 0;
  bool converged = false;
};

/// Maximum-likelihood pose from any mix of bearings, ranges and headings, started at `start`: guarded
/// Levenberg-Marquardt, which takes no step that raises the cost. What the papers leave out (000 stops at its eq 4,
/// 001 at eq 5-7), and what reaches the Cramer-Rao limit. Status `too_few` below three measurements; `degenerate` when
/// the information at the solution is singular or the solution ran off (further than 1e4 times the extent of the
/// scene); `bad_input` for non-finite numbers, std <= 0 or a negative range.
/// With a robust loss the covariance counts each measurement by its weight.
[[nodiscard]] PoseMl refinePose(std::span<const PoseMeasurement> measurements, const Pose2& start,
                                Loss loss = Loss::squared);

/// Fills in all but `start_chi2` for a descent on these measurements that ended at `pose`, with the model `there`.
void describeSolution(PoseMl& result, std::span<const PoseMeasurement> measurements, const Pose2& pose,
                      const NormalEquations<3>& there, const DescentReport& report);
}  // namespace mrpt_ext
