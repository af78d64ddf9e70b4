#pragma once

#include <functional>
#include <vector>

#include "mrpt_ext/experiment/localization_input.h"
#include "mrpt_ext/geometry/pose_estimate.h"

namespace mrpt_ext
{
/// Collects, in order of time, the estimates that a calibration may rest on: those of one dominant mode that was
/// verified. `ok` alone would be too strict: it also asks for agreement with the declared noise and share of outliers,
/// which are to be found out, and what is found where they happen to hold is biased. So a mode counts from its first
/// `ok` on for as long as it dominates, and after others competed with it if the next `ok` comes before the filter is
/// lost; where no estimate is `ok`, the longest spell of a dominant mode counts. Of independent frames each must be
/// `ok`. Estimates without a heading are left out where it is observable.
class CalibrationTrajectory
{
 public:
  explicit CalibrationTrajectory(const LocalizationConfig& config);

  /// Returns whether the estimate may count.
  bool add(const PoseEstimate& estimate);
  /// Of the estimates that were added, the share with the verdict `ok`; 0 before any.
  [[nodiscard]] double okShare() const { return added_ > 0 ? ok_ / added_ : 0; }
  /// The estimates in order of time.
  [[nodiscard]] std::vector<PoseEstimate> take();

 private:
  void endUnverified();

  double dominant_weight_;
  bool needs_heading_, independent_frames_;
  bool verified_ = false;              // an estimate was `ok` since the filter was lost
  bool interrupted_ = false;           // no mode dominated at some time since the last one
  double added_ = 0, ok_ = 0;          // estimates
  std::vector<PoseEstimate> pending_;  // dominant ones, not verified or interrupted
  std::vector<PoseEstimate> chosen_, longest_unverified_;
};

/// A pass over a log with a configuration.
using CalibrationPass = std::function<CalibrationTrajectory(const LocalizationConfig&)>;

/// The estimates of the pass that a calibration starts from. Where ranges are all there is and the pass as configured
/// is `ok` for less than half of the time, there is another one with the scale of ranges as a state of the filter, as
/// uncertain as that of uncalibrated radios, and the one that is `ok` more often counts: with a bearing a range that is
/// too long shows at once, alone it pulls the pose aside and passes for an outlier. A configuration that has states of
/// ranges says how uncertain they are.
[[nodiscard]] std::vector<PoseEstimate> likelierTrajectory(const LocalizationInput& input, const CalibrationPass& pass);

/// The same with a pass of the particle filter, or for independent frames of the closed forms.
[[nodiscard]] std::vector<PoseEstimate> calibrationTrajectory(const LocalizationInput& input, std::uint64_t seed);
}  // namespace mrpt_ext
