#pragma once

#include <vector>

#include "mrpt_ext/filter/integrity/inlier_ratio_monitor.h"
#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/filter/modes/modes.h"

namespace mrpt_ext
{
/// A pose hypothesis tracked by a Kalman filter of its own.
struct KalmanHypothesis
{
  KalmanState state;
  double log_weight = 0;
  InlierRatioMonitor fast_ratio;  ///< decides when to search elsewhere
  InlierRatioMonitor slow_ratio;  ///< decides when `ok` is justified
  std::size_t detections = 0;     ///< since it was created
};

using KalmanHypotheses = std::vector<KalmanHypothesis>;  ///< heaviest first

/// Takes the update of a hypothesis with a frame: its weight grows by the evidence, its inlier ratios follow.
void update(KalmanHypothesis& hypothesis, const KalmanUpdate& result, const Frame& frame);

/// Scales the weights to sum 1 and sorts the heaviest first.
void rank(KalmanHypotheses& hypotheses);

/// Merges duplicates: hypotheses each of which is within one standard deviation (Mahalanobis distance of the poses) of
/// the other. The heavier one stays and takes the sum of the weights.
void merge(KalmanHypotheses& hypotheses);

/// Keeps the heaviest `count` of those that weigh at least `min_weight`.
void prune(KalmanHypotheses& hypotheses, std::size_t count, double min_weight);

/// As the modes of a posterior.
[[nodiscard]] ModeSet modesOf(const KalmanHypotheses& hypotheses);
}  // namespace mrpt_ext
