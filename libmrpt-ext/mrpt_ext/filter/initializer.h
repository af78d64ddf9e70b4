#pragma once

#include <functional>
#include <span>

#include "mrpt_ext/filter/observation_model.h"
#include "mrpt_ext/filter/particle_filter_options.h"
#include "mrpt_ext/hypotheses/proposal.h"

namespace mrpt_ext
{
/// The first particles.
struct Initialization
{
  bool accepted = false;  ///< false: a later frame gives a better start
  ParticleSet particles;  ///< weighted with the measurements; of a declined start too
  ParticleSet samples;    ///< the same before weighting: log weights log(prior / density)
  Frame measurements;     ///< that they were weighted with
};

/// Draws the first particles: around a known pose, uniformly, or by annealed importance sampling from a mixture of pose
/// hypotheses and the uniform prior.
class Initializer
{
 public:
  /// All must outlive this object. `model` restarts; it weights the particles.
  Initializer(const ParticleFilterOptions& options, ObservationModel& model, RandomStream& random)
      : options_(options), model_(model), random_(random)
  {
  }

  /// `like`: a set with the origin and the systematic errors of the particles. Declined while Proposal::complete is
  /// false and there are no hypotheses, or anonymous detections leave several modes: the right one may be an inlier
  /// short of them.
  [[nodiscard]] Initialization initialize(const Frame& frame, const std::function<Proposal()>& closed_forms,
                                          const ParticleSet& like);

 private:
  [[nodiscard]] Initialization atKnownPose(const Frame& frame, const ParticleSet& like);
  /// Draws from the mixture and weights with the likelihood to the power that keeps enough effective samples, which is
  /// returned: 1 if possible.
  double draw(Initialization& start, const HypothesisSet& hypotheses, double uniform_share);
  /// Normalises the particles.
  [[nodiscard]] bool accepts(const Proposal& proposal, Initialization& start) const;

  const ParticleFilterOptions& options_;
  ObservationModel& model_;
  RandomStream& random_;
};

/// Largest exponent in (0, 1] such that the samples weighted with likelihood^exponent have `effective` effective
/// samples (annealed importance sampling: Neal, Stat. Comput. 11(2), 2001). `log_prior`: log weights before the
/// likelihood, `log_weight`: with it.
[[nodiscard]] double annealingExponent(std::span<const float> log_prior, std::span<const float> log_weight,
                                       double effective);
}  // namespace mrpt_ext
