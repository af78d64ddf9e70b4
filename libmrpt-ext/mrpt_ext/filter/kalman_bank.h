#pragma once

#include <functional>
#include <optional>
#include <string>

#include "mrpt_ext/filter/consider/consider_covariance.h"
#include "mrpt_ext/filter/integrity/filter_verdict.h"
#include "mrpt_ext/filter/integrity/recovery_policy.h"
#include "mrpt_ext/filter/kalman/kalman_hypothesis.h"
#include "mrpt_ext/hypotheses/proposal.h"

namespace mrpt_ext
{
struct KalmanBankOptions
{
  std::size_t max_hypotheses = 50;    ///< 1: a single filter
  bool iterated = false;              ///< updateIterated() instead of updateExtended()
  std::optional<GaussianPose> start;  ///< known start; absent: initialized from hypotheses
  MotionModel motion;
  bool heading_observable = true;  ///< false: one filter for all headings of a position
  BiasModel biases;
  RecoveryOptions recovery;
  VerdictOptions verdict;
};

/// Result of one frame.
struct KalmanStep
{
  ModeSet modes;  ///< one per hypothesis, with what errors that last add to the heaviest; empty until initialized
  bool restarted = false;
  KalmanUpdate best;  ///< of the heaviest hypothesis
  Verdict verdict = Verdict::lost;
  std::string reason;
};

/// Multi-hypothesis Kalman filter: one Kalman filter per pose hypothesis, weighted by its evidence.
///
/// Initialized, like the particle filter, from the poses that the closed forms propose over the window. The weight of a
/// proposal is its likelihood times the volume of its covariance (Laplace), which counts those readings. The filter
/// starts from the proposal with doubled standard deviations, updated with the newest frame, whose evidence is not
/// counted a second time. From then on weights grow by the evidence of each frame. Duplicate hypotheses are merged,
/// light ones dropped. When the detections stop agreeing with the best one, new proposals enter with the prior
/// probability of a relocalization (RecoveryPolicy). The estimate is the heaviest hypothesis, never a mean.
///
/// A proposal with unknown heading (ranges alone) becomes thirty filters, one per sector of the circle; where nothing
/// will ever tell the heading, one.
///
/// A proposal with a large covariance is not Gaussian, and a linearised filter there soon becomes overconfident: the
/// bank waits until nine tenths of the weight have half the standard deviations that `ok` allows, up to 15 s.
///
/// With one hypothesis only (a plain extended Kalman filter) there is no alternative to keep: the filter waits until
/// one proposal has nine tenths of the weight or the window is full, starts from the best one, and restarts when it is
/// lost.
class KalmanBank
{
 public:
  using HypothesisSource = std::function<Proposal()>;

  KalmanBank(KalmanBankOptions options, const LandmarkTable& map);

  KalmanStep process(const Frame& whole, const HypothesisSource& propose);

  [[nodiscard]] const KalmanHypotheses& hypotheses() const { return hypotheses_; }

 private:
  void initialize(const Frame& frame, const HypothesisSource& propose);
  /// One filter per usable proposal, weights normalised.
  [[nodiscard]] KalmanHypotheses filtersFor(const HypothesisSet& proposals) const;
  /// True when it is narrow enough to be linearised: half the standard deviations that `ok` allows.
  [[nodiscard]] bool isPrecise(const KalmanHypothesis& filter) const;
  [[nodiscard]] bool mayInitialize(const KalmanHypotheses& filters, bool complete) const;
  [[nodiscard]] KalmanHypothesis filterAt(const GaussianPose& pose, double log_weight) const;
  [[nodiscard]] KalmanUpdate updated(const KalmanState& state, const Frame& frame) const;
  void track(const Frame& frame, const HypothesisSource& propose, KalmanStep& step);
  [[nodiscard]] Recovery decideRecovery(double elapsed);
  /// True when filters were started.
  bool inject(double prior, const HypothesisSource& propose);
  void judgeStep(KalmanStep& step) const;

  KalmanBankOptions options_;
  LandmarkTable map_;
  KalmanHypotheses hypotheses_;
  double waited_ = 0;  // [s] to be initialized
  RecoveryPolicy recovery_;
  ConsiderCovariance consider_;  // of the heaviest
};
}  // namespace mrpt_ext
