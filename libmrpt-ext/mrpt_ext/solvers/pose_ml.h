#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/solvers/pose_measurement.h"

namespace mrpt_ext
{
/// Influence of large residuals. With e = residual / std and k = `PoseMlOptions::loss_scale`:
enum class Loss
{
  squared,  ///< e^2: maximum likelihood under Gaussian noise
  huber,    ///< e^2 up to k, then growing linearly
  cauchy    ///< k^2 log(1 + e^2 / k^2): gross errors have little weight
};

struct PoseMlOptions
{
  Loss loss = Loss::squared;
  double loss_scale = 2;  ///< [standard deviations]
  int max_iterations = 50;
};

struct PoseMl
{
  SolveStatus status = SolveStatus::too_few;
  GaussianPose pose;              ///< covariance = inverse Fisher information; set only when status is ok
  double chi2 = 0;                ///< sum of squared residuals / variances (sum of the losses with a robust loss)
  double start_chi2 = 0;          ///< the same at the start pose, never smaller
  double det_ratio = 0;           ///< informationRatio at the solution, in [0, 1]: quality of the geometry
  std::vector<double> residuals;  ///< predicted minus measured, in the measurements' units
  std::vector<double> weights;    ///< of each measurement in the last step: 1, or less with a robust loss
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
                                const PoseMlOptions& options = {});
}  // namespace mrpt_ext
