#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "mrpt_ext/filter/bias_filter.h"
#include "mrpt_ext/filter/consider/consider_covariance.h"
#include "mrpt_ext/filter/gaussian_tracking.h"
#include "mrpt_ext/filter/hypothesis_injector.h"
#include "mrpt_ext/filter/hypothesis_sources.h"
#include "mrpt_ext/filter/integrity/filter_diagnostics.h"
#include "mrpt_ext/filter/integrity/recovery_policy.h"
#include "mrpt_ext/filter/integrity_monitor.h"
#include "mrpt_ext/filter/mode_mixture.h"
#include "mrpt_ext/filter/observation_model.h"
#include "mrpt_ext/filter/particle_filter_options.h"
#include "mrpt_ext/filter/resampler.h"
#include "mrpt_ext/filter/sampling_error.h"

namespace mrpt_ext
{
/// Result of one frame.
struct FilterStep
{
  ModeSet modes;                        ///< without mode_of: resampling has renumbered the particles
  double effective_ratio = 1;           ///< after weighting, before resampling
  bool heading_known = true;            ///< false: the heading cannot be told, that of the modes is meaningless
  double inlier_ratio = 1;              ///< of recent detections, relative to the expected one
  bool reseeded = false;                ///< hypotheses were injected: the detections do not agree with the modes
  bool verifying = false;               ///< hypotheses were injected: they agree, but not verified (recovery_policy.h)
  bool respawned = false;               ///< a mode that had lost its particles got some again
  bool search_stopped = false;          ///< a search for hypotheses was ended by its work budget
  std::uint64_t search_operations = 0;  ///< of the searches for hypotheses (work_budget.h)
  std::size_t detections_left_out = 0;  ///< of a frame with more than a localizer works with
  std::size_t particles = 0;            ///< after the step
  std::vector<BiasEstimate> biases;     ///< in the order of ParticleFilterOptions::biases; empty before the start
  Verdict verdict = Verdict::ambiguous;
  std::string reason;
};

/// Monte Carlo localization against a landmark map (Probabilistic Robotics, table 8.2; the deviations are in
/// README.md). Particles are a structure of arrays; every reading is scored for all of them in one call. Pose
/// hypotheses initialize it, and are injected when the detections stop agreeing with the posterior, importance-weighted
/// against the prior of a relocalization (hypothesis_injector.h).
class ParticleFilter
{
 public:
  ParticleFilter(const ParticleFilterOptions& options, const LandmarkTable& map, std::uint64_t seed,
                 std::uint64_t stream);

  FilterStep process(const Frame& whole, const HypothesisSources& sources);

  /// Empty until initialized.
  [[nodiscard]] const ParticleSet& particles() const { return particles_; }
  [[nodiscard]] const LandmarkReliability& reliability() const { return observation_model_.reliability(); }

 private:
  FilterStep initialize(const Frame& frame, const HypothesisSources& sources);
  [[nodiscard]] PosteriorState assess(const Frame& frame, const HypothesisSources& sources) const;
  void predict(const OdometryMotion& motion);
  void inject(const Recovery& recovery, const Frame& frame, const HypothesisSources& sources);
  void injectTrajectory(const HypothesisSet& trajectory, const OdometryMotion& motion);
  /// The only mode as a Gaussian with its systematic errors, if it is verified and compact.
  [[nodiscard]] std::optional<KalmanState> steadyState() const;
  [[nodiscard]] GaussianUpdate updated(const KalmanState& steady, const Frame& frame);
  /// Replaces the particles by few of the Kalman posterior, if that is confirmed (gaussian_tracking.h). If it is not,
  /// they are as many as before, of the prior if they were few.
  bool track(const GaussianUpdate& update, const Frame& frame);
  void growFrom(const std::optional<KalmanState>& state);
  [[nodiscard]] std::size_t fewParticles() const { return std::min(options_.verified_particles, options_.particles); }
  [[nodiscard]] WeightParticles weigher() const;
  /// True when a mode got its particles back.
  bool weight(const Frame& frame, bool injected);
  [[nodiscard]] FilterStep estimate(const Frame& frame, Recovery::Kind injected);
  /// Finds the modes. What is stated of them: corrected for sampling and for errors that last.
  [[nodiscard]] ModeSet updateModes(const Frame& frame, double effective);
  void resample(FilterStep& step, const HypothesisSources& sources);

  [[nodiscard]] bool isUnimodal() const { return mrpt_ext::isUnimodal(modes_, options_.verdict); }
  /// One precise mode whose detections agree with it.
  [[nodiscard]] bool isTracking() const { return isUnimodal() && !integrity_.suspicious(); }
  [[nodiscard]] bool usesTrajectory(const HypothesisSources& sources, Recovery::Kind kind) const;
  /// The best mode of the last step after a motion, by odometry alone.
  [[nodiscard]] KalmanState bestModeAfter(const OdometryMotion& motion) const;
  /// The moved particles as a Gaussian, if a Kalman proposal from it may replace them.
  [[nodiscard]] std::optional<KalmanState> kalmanPrior(const OdometryMotion& motion) const;
  [[nodiscard]] std::size_t wantedParticles() const;

  ParticleFilterOptions options_;
  RandomStream random_;
  ParticleSet particles_;
  bool gaussian_ = false;  // the particles have the moments of a Gaussian exactly, and are few
  ModeSet modes_;          // of the last step, as weighted (not as stated); mode_of is only a buffer
  ObservationModel observation_model_;
  IntegrityMonitor integrity_;
  RecoveryPolicy recovery_;
  HypothesisInjector injector_;
  ModeMixture mode_mixture_;
  Resampler resampler_;
  SamplingError sampling_error_;
  ConsiderCovariance consider_;
  BiasFilter bias_filter_;
};
}  // namespace mrpt_ext
