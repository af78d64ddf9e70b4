#pragma once

#include <functional>
#include <span>

#include "mrpt_ext/filter/observation_model.h"
#include "mrpt_ext/filter/particle_filter_options.h"
#include "mrpt_ext/hypotheses/proposal.h"

namespace mrpt_ext
{
/// Result of an initialization.
struct Initialization
{
  bool accepted = false;  ///< false: wait, a later frame will constrain the pose better
  ParticleSet particles;  ///< weighted with `measurements`, also when not accepted
  ParticleSet samples;    ///< the same before weighting: log weights log(prior / proposal density)
  Frame measurements;     ///< what the particles were weighted with
  double densities = 0;   ///< computed for all draws (likelihood/scoring_work.h)
};

/// Draws the first particles: around a known pose, uniformly, or by annealed importance sampling from a mixture of pose
/// hypotheses and the uniform prior.
class Initializer
{
 public:
  /// All must outlive this object. `model` is restarted and then weights the particles.
  Initializer(const ParticleFilterOptions& options, ObservationModel& model, RandomStream& random)
      : options_(options), model_(model), random_(random)
  {
  }

  /// `like` gives origin and systematic errors of the new particle set. Before Proposal::complete, an initialization is
  /// not accepted without hypotheses, nor while anonymous detections leave several modes: the right pose may have one
  /// inlier too few so far, and be missing.
  [[nodiscard]] Initialization initialize(const Frame& frame, const std::function<Proposal()>& closed_forms,
                                          const ParticleSet& like);

 private:
  [[nodiscard]] Initialization atKnownPose(const Frame& frame, const ParticleSet& like);
  /// Draws from the mixture of hypotheses and uniform prior, and weights with likelihood^exponent. Returns the
  /// exponent: the largest one that keeps enough effective samples, 1 if possible. What takes too long is scored with
  /// fewer samples, then with fewer detections (likelihood/scoring_work.h).
  double draw(Initialization& start, const Frame& measurements, const HypothesisSet& hypotheses, double uniform_share);
  /// The number of samples to draw, if no more than `most` are affordable: never fewer than particles are wanted.
  [[nodiscard]] std::size_t affordableSamples(double most) const;
  /// True if the filter may start from these particles, which are normalised here.
  [[nodiscard]] bool accepts(const Proposal& proposal, Initialization& start) const;

  const ParticleFilterOptions& options_;
  ObservationModel& model_;
  RandomStream& random_;
};

/// Largest exponent in (0, 1] for which the effective sample size, after weighting with likelihood^exponent, reaches
/// `effective` (annealed importance sampling: Neal, Stat. Comput. 11(2), 2001). `log_prior`: log weights without the
/// likelihood; `log_weight`: with it.
[[nodiscard]] double annealingExponent(std::span<const float> log_prior, std::span<const float> log_weight,
                                       double effective);
}  // namespace mrpt_ext
