#pragma once

#include <vector>

#include "mrpt_ext/filter/integrity/inlier_ratio_monitor.h"
#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"

namespace mrpt_ext
{
/// One place where the robot may be, tracked by a Kalman filter of its own.
struct KalmanHypothesis
{
  KalmanState state;
  double log_weight = 0;
  InlierRatioMonitor quick;    ///< tells when to look elsewhere
  InlierRatioMonitor trust;    ///< slower: tells when to claim `ok`
  std::size_t detections = 0;  ///< seen since it was made
};

using KalmanHypotheses = std::vector<KalmanHypothesis>;  ///< heaviest first

/// Updates a hypothesis with a frame; its weight grows by the evidence, its monitors see which share of the detections
/// it explains.
void update(KalmanHypothesis& hypothesis, const KalmanUpdate& result, const Frame& frame);

/// Scales the weights to sum 1 and puts the heaviest first.
void rank(KalmanHypotheses& hypotheses);

/// Joins what has become the same place: two hypotheses each of which lies within one standard deviation (Mahalanobis
/// distance of the poses) of the other. The heavier one stays and takes the sum of the weights.
void merge(KalmanHypotheses& hypotheses);

/// Keeps the heaviest `count` of those that weigh at least `min_weight`.
void prune(KalmanHypotheses& hypotheses, std::size_t count, double min_weight);

/// As the modes of a posterior.
[[nodiscard]] ModeSet modesOf(const KalmanHypotheses& hypotheses);
}  // namespace mrpt_ext
