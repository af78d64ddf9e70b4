#pragma once

#include <algorithm>
#include <cstddef>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
/// When the filter should look for the robot elsewhere.
struct RecoveryOptions
{
  double reseed_inlier_ratio = 0.5;  ///< below this explained share (relative to what is expected) seeds are injected
  double lost_share = 0.3;           ///< below this the verdict is `lost`
  double memory_detections = 12;     ///< the average forgets over about this many detections
  double trust_memory = 60;          ///< [detections] the same for the average that `ok` rests on
  double surprise_memory = 4;        ///< [detections] the same for the average that withholds `ok` at once
  double injected_particle_share = 0.25;  ///< of the particle count, added per frame while suspicious
  double min_interval = 0.5;              ///< [s] between two injections, which are costly
  double challenge_interval = 3;          ///< [s] after which seeds challenge a place that is not proven
  double review_interval = 20;            ///< [s] likewise a proven one, where detections have no names
  double relocalization_prior = 0.02;     ///< probability per injection, that the robot is somewhere else
  double share_of_slips =
      0.5;                   ///< of the jumps are errors of odometry (wheels slipped, a long gap); others go anywhere
  double slip_std_xy = 0.3;  ///< [m] of such an error
  double slip_std_phi = degToRad(25.0);  ///< [rad]
};

/// The same with the memory of the average that `ok` rests on.
[[nodiscard]] inline RecoveryOptions slowRatioOptions(RecoveryOptions options)
{
  options.memory_detections = options.trust_memory;
  return options;
}

/// The same with the memory of the average that withholds `ok`.
[[nodiscard]] inline RecoveryOptions immediateRatioOptions(RecoveryOptions options)
{
  options.memory_detections = options.surprise_memory;
  return options;
}

/// Running share of detections that the posterior explains.
/// A tracker that sits at the right place explains all but the clutter; one at the wrong place explains only what
/// happens to fit by chance.
class InlierRatioMonitor
{
 public:
  explicit InlierRatioMonitor(const RecoveryOptions& options) : options_(options) {}

  /// `explained_share` of `detections`, where `expected_share` would be normal (one minus the clutter probability).
  void observe(double explained_share, double expected_share, std::size_t detections)
  {
    if (detections == 0) return;
    const double relative = std::min(1.0, explained_share / std::max(expected_share, 0.05));
    const double memory = std::max(1.0, std::min(options_.memory_detections, count_ + static_cast<double>(detections)));
    const double gain = std::min(1.0, static_cast<double>(detections) / memory);
    average_ += gain * (relative - average_);
    count_ += static_cast<double>(detections);
  }
  /// Explained share over the last detections relative to what is expected, in [0, 1]; 1 before any.
  [[nodiscard]] double average() const { return average_; }
  [[nodiscard]] bool suspicious() const { return average_ < options_.reseed_inlier_ratio; }
  [[nodiscard]] bool lost() const { return average_ < options_.lost_share; }

 private:
  RecoveryOptions options_;
  double average_ = 1;
  double count_ = 0;
};
}  // namespace mrpt_ext
