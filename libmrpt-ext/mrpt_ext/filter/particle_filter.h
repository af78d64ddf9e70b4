#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "mrpt_ext/filter/initialization.h"
#include "mrpt_ext/filter/integrity/filter_diagnostics.h"
#include "mrpt_ext/filter/integrity/filter_verdict.h"
#include "mrpt_ext/filter/integrity/independent_detections.h"
#include "mrpt_ext/filter/integrity/inlier_ratio_monitor.h"
#include "mrpt_ext/filter/integrity/landmark_reliability.h"
#include "mrpt_ext/filter/integrity/pose_verification_test.h"
#include "mrpt_ext/filter/integrity/sensor_monitors.h"
#include "mrpt_ext/filter/mode_mixture.h"
#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/filter/motion/motion_model.h"
#include "mrpt_ext/filter/particles/kld_size.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/filter/particles/resampling.h"
#include "mrpt_ext/filter/regularization.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"
#include "mrpt_ext/hypotheses/pose_region.h"

namespace mrpt_ext
{
/// Where the first particles come from.
enum class InitialMode
{
  analytic,  ///< uniform over the region plus the hypotheses that the first frame gives
  uniform,   ///< uniform over the region
  gaussian   ///< around a known start
};

struct ParticleFilterOptions
{
  std::size_t particles = 2000;           ///< number held (with an adaptive size: only at the start, see kld)
  std::size_t initial_particles = 20000;  ///< number held while the place is not certain
  PoseRegion region;                      ///< where the robot can start, and be found again
  InitialMode initial_mode = InitialMode::analytic;
  GaussianPose initial_pose;  ///< for InitialMode::gaussian
  MotionModel motion;
  BiasModel biases;  ///< systematic errors estimated with the pose
  ResamplingMethod resampling = ResamplingMethod::systematic;
  double resample_below = 0.5;  ///< effective sample ratio
  bool adaptive_size = false;   ///< KLD sample size
  KldOptions kld;
  Regularization smoothing;
  ModeOptions modes;
  RecoveryOptions recovery;
  VerdictOptions verdict;
  SequentialPoseTestOptions evidence;
  bool companions = true;          ///< Kalman filters divide the weight between compact modes
  std::size_t redraw_below = 400;  ///< effective particles: fewer are drawn anew around an analytic posterior
  bool learn_reliability = true;
  double reliability_prior_strength = 30;            ///< detections
  double max_clutter = 0.7;                          ///< a landmark is never trusted less than this
  Vector3d seed_min_std{0.03, 0.03, degToRad(1.0)};  ///< floor of the spread of seeds
  unsigned threads = 1;                              ///< scoring threads; the result does not depend on it
};

/// What the filter says after one frame.
struct FilterStep
{
  ModeSet modes;                     ///< without mode_of: resampling has renumbered the particles
  double effective_ratio = 1;        ///< after scoring, before resampling
  double explained_share = 1;        ///< of recent detections, relative to what is expected
  bool reseeded = false;             ///< seeds were injected, because the detections do not agree
  bool challenged = false;           ///< seeds were injected beside a place that only a rival can put to the test
  bool revived = false;              ///< a place that had lost its particles got some again
  std::size_t particles = 0;         ///< held after the step
  std::vector<BiasEstimate> biases;  ///< in the order of ParticleFilterOptions::biases; empty before the start
  Verdict verdict = Verdict::ambiguous;
  std::string reason;
};

/// Monte Carlo localization against a landmark map, state as a structure of arrays, every reading scored for all
/// particles in one call. Analytic hypotheses seed it at the start and when the detections stop agreeing with the
/// posterior; seeds are importance-weighted against the uniform prior, so a wrong seed costs particles, not truth.
class ParticleFilter
{
 public:
  /// Asked for hypotheses only when the filter needs some: at the start and on recovery.
  using HypothesisSource = std::function<Proposal()>;
  /// Asked for the places where the robot may be at the newest frame, weighted by all that was seen along the way
  /// behind it; those that the filter holds likeliest are among them, and the weights leave room for none of them.
  /// Empty: it has nothing new to say. Absent: it is not there to be asked.
  using TrajectoryHypotheses = std::function<HypothesisSet()>;

  ParticleFilter(const ParticleFilterOptions& options, const LandmarkTable& map, std::uint64_t seed,
                 std::uint64_t stream);

  /// `since_start`: all readings so far, seen from the newest frame, while they are all there and odometry between them
  /// is surer than they are; else empty. With them particles are kept apart until the place is known (resample_move.h).
  FilterStep process(const Frame& frame, const HypothesisSource& propose, std::span<const Reading> since_start = {},
                     const TrajectoryHypotheses& along_way = {});

  [[nodiscard]] const ParticleSet& particles() const { return particles_; }
  [[nodiscard]] const LandmarkReliability& reliability() const { return reliability_; }

 private:
  /// Draws and scores the first particles; false when a later frame can make a better start.
  bool start(const Frame& frame, const HypothesisSource& propose);
  bool startAtKnownPose(const Frame& frame);
  /// Judges the first sample, which is normalised for it. Named detections need a hypothesis only. What anonymous ones
  /// fit is many places, and sometimes the right one less than others: one place must be left, or all be joined.
  [[nodiscard]] bool mayStart(const Proposal& proposal, const Frame& evidence);
  /// Seeds that have the weight `jump` together.
  void inject(const HypothesisSource& propose, double jump);
  /// Particles for the places that the way behind speaks for, with the weight that it gives them
  /// (hypothesis_injection.h).
  void believe(const HypothesisSet& along_way, const OdometryMotion& motion);
  /// The places held possible, as wide as they are when odometry was wrong by more than it may be.
  [[nodiscard]] HypothesisSet slippedPlaces() const;
  [[nodiscard]] bool looksElsewhere() const { return monitor_.suspicious() || kinds_.dropped() || evidence_.refuted(); }
  [[nodiscard]] bool challengeDue(const Frame& frame, bool one_place, bool way_is_known) const;
  /// What fresh looks prove is one place: the best mode, until another one has most of the weight or it grows vague. A
  /// rival that comes and goes takes nothing from what was proven before.
  void followEvidence(const Frame& frame, const ModeSet& modes);
  void track(const Frame& frame, const HypothesisSource& propose, const TrajectoryHypotheses& along_way,
             FilterStep& step);
  /// The readings that the particles are weighed by: all, or, while the place is not proven, without repeated looks.
  [[nodiscard]] std::vector<Reading> weighed(const std::vector<Reading>& readings, bool sought);
  void score(const Frame& frame);
  /// Where the best mode of the last step is after a motion, by odometry alone.
  [[nodiscard]] KalmanState bestPlaceAfter(const OdometryMotion& motion) const;
  /// The moved particles as a Gaussian, where they are few and at one place.
  [[nodiscard]] std::optional<KalmanState> priorOfOnePlace(const Frame& frame) const;
  void redrawIfFew(const KalmanState& prior, const Frame& frame);
  void scoreReading(const Reading& reading);
  void checkAgreement(const Frame& frame, bool learn);
  [[nodiscard]] VerdictWithReason judgeStep(const FilterStep& step) const;
  [[nodiscard]] std::size_t wantedParticles(const ModeSet& modes) const;
  void resample(const ModeSet& modes, std::size_t count);
  void moveByReadings(std::span<const Reading> since_start);
  /// What is left in the mean of the sampling errors of the steps before, as a share of its covariance.
  [[nodiscard]] double earlierSamplingError(const Frame& frame, const ModeSet& modes) const;

  ParticleFilterOptions options_;
  LandmarkTable map_;
  RandomStream random_;
  ParticleSet particles_;
  ParticleSet spare_;             // memory to resample into
  std::vector<int> mode_memory_;  // memory for the modes of the particles
  LandmarkReliability reliability_;
  InlierRatioMonitor monitor_;   // quick, against what is learned about the landmarks: tells when to look elsewhere
  InlierRatioMonitor trust_;     // slow, against what the configuration promises: tells when to claim `ok`
  InlierRatioMonitor surprise_;  // quickest: `ok` is not said in the face of it
  SensorMonitors kinds_;         // of each sensor by itself
  DetectionDecorrelator looks_;  // what a robot that is sought is weighed by
  SequentialPoseTest evidence_;  // fresh looks: tells whether the place is more than a chance fit
  ModeMixture companions_;
  std::optional<KalmanState> tested_;  // the place that evidence_ is about
  double challenge_pause_;             // [s] until it is challenged; each one it stands doubles it
  bool contradicted_ = false;          // the way behind speaks for another place than the one that is held
  ModeSet modes_;                      // of the last step
  double sampling_error_ = 0;          // variance of the last mean by sampling alone, as a share of its covariance
  double since_injection_ = std::numeric_limits<double>::infinity();  // [s]
};
}  // namespace mrpt_ext
