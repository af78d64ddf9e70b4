#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/solve_status.h"
#include "mrpt_ext/solvers/pose_measurement.h"

namespace mrpt_ext
{
/// The limits are judged at the estimate, where the bound is known to a fifth or so: at 4 % practically all scenes are
/// flagged whose true bound exceeds 5 % of the side (study cramer_rao), and of those below, the ones near it.
struct IdentifiedPoseOptions
{
  double max_relative_error = 0.04;  ///< of the position, against the extent of the scene; beyond: degenerate
  double extent = 0;  ///< [m] of the scene, e.g. the side of the map; 0: as far as the landmarks and the robot spread
  double max_curvature = 1;       ///< PoseCurvature::rms; beyond: degenerate
  double max_stretch = 1.5;       ///< PoseCandidate::stretch; beyond: degenerate
  double min_consistency = 1e-6;  ///< probability of residuals as large as these; below: none
  double rival_chi2 = 20;         ///< a minimum is a candidate when its chi2 is within this of the best
};

/// One minimum of the sum of squares.
struct PoseCandidate
{
  GaussianPose pose;             ///< covariance: inverse Fisher information and what bends away from it
  bool heading_known = true;     ///< false: no measurement tells the heading; it is 0, its variance that of any heading
  double chi2 = 0;               ///< sum of squared residuals / variances
  double probability = 0;        ///< share of the candidates' likelihood, each integrated over its Gaussian
  double information_ratio = 0;  ///< informationRatio, in [0, 1]: quality of the geometry
  double relative_error = 0;     ///< bound of the position's standard deviation / extent of the scene
  double curvature = 0;          ///< PoseCurvature::rms: above about 1 the covariance is only indicative
  double stretch = 1;            ///< how much less than its parabola chi2 rises three standard deviations away, at most
};

struct IdentifiedPose
{
  SolveStatus status = SolveStatus::too_few;
  std::vector<PoseCandidate> candidates;  ///< likeliest first; also with `degenerate` and `none`, where there are any
  int degrees_of_freedom = 0;             ///< measurements beyond those that a pose needs
  double consistency = 0;                 ///< probability of a larger chi2 than the best one's; 1 without redundancy

  /// One pose, and nothing speaks against it.
  [[nodiscard]] bool unique() const { return status == SolveStatus::ok && candidates.size() == 1; }
};

/// Pose from measurements of known landmarks: bearings, ranges, headings in any mix, by sensors anywhere on the robot.
/// Closed forms from minimal subsets (minimal_solvers.h) are judged by all measurements, the best are refined to the
/// maximum of the likelihood, and every distinct maximum that is nearly as likely as the best is returned: two ranges
/// give two mirror images, three and more bearings one pose as a rule. Status: `ok`; `too_few` the heading or the
/// position stays on a curve whatever the values are (less than three measurements; two when they are ranges, which
/// give a position without heading); `degenerate` the geometry leaves the pose to noise: singular information, a
/// standard deviation of the position beyond `max_relative_error`, or a likelihood too bent for its covariance (robot
/// and landmarks near one circle or one line, robot nearly on a landmark); `none` the residuals contradict the stated
/// standard deviations; `bad_input`.
[[nodiscard]] IdentifiedPose solvePoseFromLandmarks(std::span<const PoseMeasurement> measurements,
                                                    const IdentifiedPoseOptions& options = {});
}  // namespace mrpt_ext
