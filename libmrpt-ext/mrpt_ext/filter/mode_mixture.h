#pragma once

#include <vector>

#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/filter/particle_moments.h"

namespace mrpt_ext
{
/// A Kalman filter that goes along with one compact mode of the particles.
struct MixtureComponent
{
  KalmanState state;
  double log_evidence = 0;  ///< of the frame in work
  double log_weight = 0;    ///< of a place without particles, where those of all particles sum to 1
  bool has_particles = true;
  double alone_for = 0;                ///< [s] without particles
  double owed = 0, owed_variance = 0;  ///< log weight that the particles would have given it beyond what it got

  /// Books what the particles say beyond the companion (log units), with its sampling variance; returns what is due:
  /// nothing while the sum may be chance, else all of it.
  double settle(double difference, double variance);
};

/// Keeps the account of several places where the robot may be.
///
/// With N particles the evidence of a mode has a sampling error of about 1 / sqrt(N) in every frame; it adds up, and
/// two places that are exactly as likely drift apart although the posterior stays at one half each. A Kalman filter per
/// mode has no sampling error. So the particles decide how much weight all companied modes have together and how each
/// is shaped, the companions how the weight is divided among them (a mixture Kalman filter for the weights: Chen and
/// Liu, J. R. Stat. Soc. B 62(3), 2000). Where a companion's evidence and that of its particles differ by more than
/// chance explains, because the mode is no Gaussian, the particles have the last word.
///
/// A place that lost its particles (two of a symmetric room, of which one was dropped; the old place, when the robot
/// was sought elsewhere) is watched on for a while. When the evidence since then speaks for it again, it gets particles
/// again: so a choice made too early, or a seed that was believed too soon, is taken back.
class ModeMixture
{
 public:
  ModeMixture(MotionModel motion, BiasModel biases) : motion_(motion), biases_(std::move(biases)) {}

  [[nodiscard]] bool empty() const { return companions_.empty(); }
  [[nodiscard]] const std::vector<MixtureComponent>& all() const { return companions_; }
  void clear() { companions_.clear(); }

  /// Before the particles are scored: moves and updates all companions, notes which particles are theirs.
  void predictAndUpdate(const ParticleSet& moved_particles, const Frame& frame, const LandmarkTable& map);
  /// After the particles were scored, before they are normalised: divides the weight.
  void reweight(ParticleSet& particles);
  /// Particles for the places that have become likely again, `count` for each; true when there were any.
  bool revive(ParticleSet& particles, std::size_t count, RandomStream& random);
  /// After the modes were found: new places get a companion, companions of dropped modes stay without particles.
  void follow(const ModeSet& modes, const ParticleSet& particles);
  /// Watches a mode even though it is the only one: the robot will be sought elsewhere.
  void watch(const Mode& mode, const ParticleSet& particles);

 private:
  void seat(const ModeSet& modes, std::size_t mode, const ParticleSet& particles);
  static void retire(MixtureComponent& companion);
  void forget();

  MotionModel motion_;
  BiasModel biases_;
  std::vector<MixtureComponent> companions_;
  std::vector<int> companion_of_;   // per particle, while a frame is in work
  std::vector<double> prior_mass_;  // of its particles, before scoring
};

/// Number of modes, all of them compact, that together hold 99 % of the weight; 0 when some of it lies elsewhere.
[[nodiscard]] std::size_t countPlaces(const ModeSet& modes);
}  // namespace mrpt_ext
