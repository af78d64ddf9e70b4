#pragma once

#include <algorithm>
#include <cstddef>

#include "mrpt_ext/filter/integrity/recovery_options.h"

namespace mrpt_ext
{
/// Exponential average of the inlier ratio: the share of detections that are inliers of the posterior, relative to the
/// share that is expected (w_fast and w_slow of augmented Monte Carlo localization: Thrun, Burgard, Fox, Probabilistic
/// Robotics, 8.3.5). At the right pose all detections but the clutter are inliers; at a wrong one only those that fit
/// by chance.
class InlierRatioMonitor
{
 public:
  /// Decides when to search elsewhere.
  [[nodiscard]] static InlierRatioMonitor fast(const RecoveryOptions& options) { return {options, 12}; }
  /// Decides when `ok` is justified.
  [[nodiscard]] static InlierRatioMonitor slow(const RecoveryOptions& options) { return {options, 60}; }
  /// Withholds `ok` at once.
  [[nodiscard]] static InlierRatioMonitor immediate(const RecoveryOptions& options) { return {options, 4}; }

  /// The pose is known: as if all detections it remembers had fitted. Else the first ones decide alone.
  void trust()
  {
    average_ = 1;
    count_ = memory_;
  }
  /// `inlier_ratio` of `detections`, where `expected_ratio` would be normal (one minus the clutter probability).
  void observe(double inlier_ratio, double expected_ratio, std::size_t detections)
  {
    if (detections == 0) return;
    const double relative = std::min(1.0, inlier_ratio / std::max(expected_ratio, 0.05));
    const double memory = std::max(1.0, std::min(memory_, count_ + static_cast<double>(detections)));
    const double gain = std::min(1.0, static_cast<double>(detections) / memory);
    average_ += gain * (relative - average_);
    count_ += static_cast<double>(detections);
  }
  /// Inlier ratio of recent detections relative to the expected one, in [0, 1]; 1 before any.
  [[nodiscard]] double average() const { return average_; }
  [[nodiscard]] bool suspicious() const { return average_ < reseed_ratio_; }
  [[nodiscard]] bool lost() const { return average_ < lost_ratio_; }

 private:
  /// `memory` [detections]: of the average.
  InlierRatioMonitor(const RecoveryOptions& options, double memory)
      : reseed_ratio_(options.reseed_inlier_ratio), lost_ratio_(options.lost_inlier_ratio), memory_(memory)
  {
  }

  double reseed_ratio_, lost_ratio_;
  double memory_;
  double average_ = 1;
  double count_ = 0;
};
}  // namespace mrpt_ext
