#pragma once

#include <limits>

#include "mrpt_ext/filter/integrity/recovery_options.h"

namespace mrpt_ext
{
/// What a recovery depends on: the posterior before the frame, and what the frame offers. The Kalman bank sets
/// `suspicious` only; without the others there is no verification.
struct PosteriorState
{
  bool suspicious = false;      ///< the measurements do not agree with it
  bool unimodal = false;        ///< one precise mode
  bool verified = false;        ///< ... that the sequential test has accepted
  bool anonymous = false;       ///< the frame has anonymous detections
  bool ends_gap = false;        ///< the frame tests a pose that was predicted over a gap
  bool has_trajectory = false;  ///< a trajectory search can give hypotheses
};

struct Recovery
{
  enum class Kind
  {
    none,
    reseed,  ///< the measurements do not agree with the posterior: find the robot again
    verify   ///< they agree, but so may another pose: let hypotheses from elsewhere compete
  };
  Kind kind = Kind::none;
  double prior = 0;  ///< probability that the robot is elsewhere: weight of all injected hypotheses together

  [[nodiscard]] bool due() const { return kind != Kind::none; }
};

/// Decides when a filter injects hypotheses. Augmented Monte Carlo localization (Probabilistic Robotics, table 8.3)
/// injects in every step; here an injection costs as much as many steps, so it happens at intervals:
/// - reseed: every RecoveryOptions::min_interval. For the Kalman bank alone, the interval doubles with every reseeding,
///   up to `max_reseed_interval`, until resetReseeding().
/// - verify (particle filter only): at an interval that doubles with every verification that the mode survives, while
///   the prior falls in proportion. A verified mode is tested at the longest interval, where another pose could fit.
///   Never by a frame that ends a gap, which tests the pose before anything else.
class RecoveryPolicy
{
 public:
  static constexpr double kMinVerificationInterval = 3, kMaxVerificationInterval = 20;  ///< [s]

  /// `max_reseed_interval` [s]: of the Kalman bank; 0 keeps the interval constant, as in the particle filter.
  explicit RecoveryPolicy(const RecoveryOptions& options, double max_reseed_interval = 0)
      : options_(options), max_reseed_interval_(max_reseed_interval)
  {
  }

  /// `elapsed` [s]: since the last decision. The caller injects what is due.
  [[nodiscard]] Recovery decide(const PosteriorState& state, double elapsed);
  /// The filter was initialized: the first interval begins (Kalman bank; in the particle filter nothing delays the
  /// first recovery).
  void start() { since_injection_ = 0; }
  /// The measurements agree with the posterior: the next reseeding need not wait (Kalman bank).
  void resetReseeding() { reseed_interval_ = options_.min_interval; }
  /// Another mode is under test: verification starts again at the shortest interval (particle filter).
  void resetVerification() { verification_interval_ = kMinVerificationInterval; }
  /// True after start() or the first recovery that was due.
  [[nodiscard]] bool hasInjected() const { return since_injection_ < std::numeric_limits<double>::infinity(); }

 private:
  [[nodiscard]] bool isVerificationDue(const PosteriorState& state) const;

  RecoveryOptions options_;
  double max_reseed_interval_;
  double since_injection_ = std::numeric_limits<double>::infinity();  // [s]
  double reseed_interval_ = options_.min_interval;                    // [s]
  double verification_interval_ = kMinVerificationInterval;           // [s]
};
}  // namespace mrpt_ext
