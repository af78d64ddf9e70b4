#pragma once

#include <vector>

#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/filter/particle_moments.h"

namespace mrpt_ext
{
/// A Kalman filter that tracks one compact mode of the particles.
struct MixtureComponent
{
  KalmanState state;
  double log_evidence = 0;  ///< of the current frame
  double log_weight = 0;    ///< of a mode without particles, where those of all particles sum to 1
  bool has_particles = true;
  double unsupported_for = 0;                         ///< [s] without particles
  double weight_residual = 0, residual_variance = 0;  ///< log weight of the particles minus that of the filter

  /// Takes how far the particles' log weight exceeds that of the filter in one frame, with its sampling variance.
  /// Returns the correction: 0 while the sum of the residuals is within chance, else all of it.
  double correctWeight(double residual, double variance);
};

/// Divides the weight between the modes of an ambiguous posterior.
///
/// With N particles the evidence of a mode has a sampling error of about 1 / sqrt(N) in every frame. The errors
/// accumulate, and two equally likely modes drift apart although the posterior stays at one half each. A Kalman filter
/// per mode has no sampling error. So the particles determine the shape of each mode and the weight of all tracked
/// modes together, the Kalman filters how that is divided (a mixture Kalman filter for the weights: Chen and Liu, J. R.
/// Stat. Soc. B 62(3), 2000). Where the evidence of a Kalman filter and that of the particles differ significantly,
/// because the mode is not Gaussian, the particles prevail.
///
/// A mode that lost its particles (one of two in a symmetric room; the old mode after hypotheses were injected) is
/// tracked for a while. When it becomes likely again, it gets particles again: a wrong decision can be reversed.
class ModeMixture
{
 public:
  ModeMixture(MotionModel motion, BiasModel biases) : motion_(motion), biases_(std::move(biases)) {}

  [[nodiscard]] bool empty() const { return components_.empty(); }
  [[nodiscard]] const std::vector<MixtureComponent>& components() const { return components_; }
  void clear() { components_.clear(); }

  /// Before the particles are weighted: predicts and updates all components, assigns the particles to them.
  void predictAndUpdate(const ParticleSet& predicted, const Frame& frame, const LandmarkTable& map);
  /// After the particles were weighted, before they are normalised: divides the weight.
  void reweight(ParticleSet& particles);
  /// Draws `count` particles for each mode without particles that has become likely again; true when there were any.
  bool respawn(ParticleSet& particles, std::size_t count, RandomStream& random);
  /// After the modes were found: new modes get a component, components of lost modes stay without particles.
  void associate(const ModeSet& modes, const ParticleSet& particles);
  /// Tracks a mode even though it is the only one: hypotheses from elsewhere will compete with it.
  void retain(const Mode& mode, const ParticleSet& particles);

 private:
  void assignParticles(const ParticleSet& predicted);
  void add(const ModeSet& modes, std::size_t mode, const ParticleSet& particles);
  static void detach(MixtureComponent& component);
  void prune();

  MotionModel motion_;
  BiasModel biases_;
  std::vector<MixtureComponent> components_;
  std::vector<int> component_of_;   // per particle, during a frame
  std::vector<double> prior_mass_;  // per component: weight of its particles before weighting
};

/// Number of modes, all of them compact, that together hold 99 % of the weight; 0 when some of it is elsewhere.
[[nodiscard]] std::size_t countCompactModes(const ModeSet& modes);
}  // namespace mrpt_ext
