#pragma once

#include <vector>

#include "mrpt_ext/experiment/localization_input.h"
#include "mrpt_ext/geometry/pose_estimate.h"

namespace mrpt_ext
{
/// Collects, in order of time, the estimates that a calibration may rest on: those of one dominant mode that was
/// verified. `ok` alone would be too strict: it also asks for agreement with the declared noise and share of outliers,
/// which are to be found out, and what is found where they happen to hold is biased. So a mode counts from its first
/// `ok` on for as long as it dominates; where no estimate is `ok`, the longest spell of a dominant mode counts. Of
/// independent frames each must be `ok`. Estimates without a heading are left out where it is observable.
class CalibrationTrajectory
{
 public:
  explicit CalibrationTrajectory(const LocalizationConfig& config);

  /// Returns whether the estimate may count.
  bool add(const PoseEstimate& estimate);
  /// The estimates in order of time.
  [[nodiscard]] std::vector<PoseEstimate> take();

 private:
  void endUnverified();

  double min_best_weight_;
  bool needs_heading_, independent_frames_;
  bool verified_ = false;              // an estimate was `ok` since the filter was lost
  bool interrupted_ = false;           // no mode dominated at some time since the last one
  std::vector<PoseEstimate> pending_;  // dominant ones, not verified or interrupted
  std::vector<PoseEstimate> chosen_, longest_unverified_;
};

/// The trajectory of the particle filter for a calibration, or for independent frames that of the closed forms.
[[nodiscard]] std::vector<PoseEstimate> calibrationTrajectory(const LocalizationInput& input, std::uint64_t seed);
}  // namespace mrpt_ext
