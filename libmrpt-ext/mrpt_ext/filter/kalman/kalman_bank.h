#pragma once

#include <functional>
#include <optional>
#include <string>

#include "mrpt_ext/filter/initialization.h"
#include "mrpt_ext/filter/integrity/filter_verdict.h"
#include "mrpt_ext/filter/kalman/kalman_hypothesis.h"

namespace mrpt_ext
{
struct KalmanBankOptions
{
  std::size_t max_hypotheses = 50;    ///< 1: a single filter
  bool iterated = false;              ///< updateIterated() instead of updateExtended()
  std::optional<GaussianPose> start;  ///< known start; absent: started from hypotheses
  MotionModel motion;
  BiasModel biases;
  RecoveryOptions recovery;
  VerdictOptions verdict;
  Vector3d seed_min_std{0.03, 0.03, degToRad(1.0)};  ///< floor of the spread of hypotheses that start filters
};

/// What the bank says after one frame.
struct KalmanStep
{
  ModeSet modes;  ///< one per hypothesis; empty while there is nothing to start from
  bool restarted = false;
  KalmanUpdate best;  ///< of the heaviest hypothesis
  Verdict verdict = Verdict::lost;
  std::string reason;
};

/// Kalman filters side by side, one per place where the robot may be, weighted by their evidence.
///
/// Started, like the particle filter, from the poses that the closed forms propose over the readings of the last
/// seconds: each proposal's weight is its likelihood times the volume of its covariance (Laplace), which counts those
/// readings; the filter starts from the proposal widened to twice its deviations and sharpened again by the newest
/// frame, whose evidence is then not counted a second time. From then on weights grow by the evidence of each frame.
/// Hypotheses that have become the same are joined, light ones dropped. When the best one stops explaining the
/// detections, new proposals enter with the prior probability of a jump. The estimate is the heaviest one, never a
/// mean.
///
/// A place with any heading (ranges alone) is followed by thirty filters, one per sector of the circle.
///
/// A place that is hardly narrowed down has no Gaussian shape, and a linearised filter there soon believes too much:
/// the bank waits until nine tenths of the weight are in places twice as sharp as the verdict `ok` asks, up to 15 s.
///
/// With one hypothesis only (an extended Kalman filter as everyone knows it) there is no second place to keep: the
/// filter waits until one proposal has nine tenths of the weight or all readings of the window are there, starts from
/// the best one, and starts again when it is lost.
class KalmanBank
{
 public:
  using HypothesisSource = std::function<Proposal()>;

  KalmanBank(KalmanBankOptions options, const LandmarkTable& map)
      : options_(std::move(options)), map_(map), pause_(options_.recovery.min_interval)
  {
  }

  KalmanStep process(const Frame& frame, const HypothesisSource& propose);

  [[nodiscard]] const KalmanHypotheses& hypotheses() const { return hypotheses_; }

 private:
  void start(const Frame& frame, const HypothesisSource& propose);
  /// One filter per proposal that is worth it, weights normalised.
  [[nodiscard]] KalmanHypotheses filtersFor(const HypothesisSet& proposals) const;
  /// True when it is narrow enough to be linearised: half the deviations that `ok` allows.
  [[nodiscard]] bool isPrecise(const KalmanHypothesis& filter) const;
  [[nodiscard]] bool mayStart(const KalmanHypotheses& filters, bool complete) const;
  [[nodiscard]] KalmanHypothesis filterAt(const GaussianPose& pose, double log_weight) const;
  [[nodiscard]] KalmanUpdate updated(const KalmanState& state, const Frame& frame) const;
  void track(const Frame& frame, const HypothesisSource& propose, KalmanStep& step);
  void lookElsewhere(const HypothesisSource& propose, KalmanStep& step);
  void judgeStep(KalmanStep& step) const;

  KalmanBankOptions options_;
  LandmarkTable map_;
  KalmanHypotheses hypotheses_;
  double waited_ = 0;         // [s] for a start
  double since_restart_ = 0;  // [s]
  double pause_;              // [s] until it looks elsewhere again: what was sought in vain is sought less often
};
}  // namespace mrpt_ext
