#pragma once

#include "mrpt_ext/filter/gaussian_proposal.h"

namespace mrpt_ext
{
/// `count` particles of equal weight with exactly these moments.
[[nodiscard]] ParticleSet drawGaussian(const ParticleSet& like, const KalmanState& state, std::size_t count,
                                       RandomStream& random);

/// The iterated Kalman update of a Gaussian, and what is needed to judge it.
struct GaussianUpdate
{
  KalmanState prior, posterior;
  ParticleSet samples;  ///< of the prior, importance-weighted: most are where the posterior is
};

/// `like`: particles of the same kind as the `count` samples.
[[nodiscard]] GaussianUpdate updateGaussian(const KalmanState& prior, const Frame& frame, const LandmarkTable& map,
                                            const ParticleSet& like, std::size_t count, RandomStream& random);

/// True if the Kalman posterior is the posterior: the samples, weighted with the likelihood of the same frame, with
/// clutter, confusable landmarks and the exact measurement functions in it, keep an effective ratio of at least one
/// half. A wrong association, a bent or a second mode takes most of their weight.
[[nodiscard]] bool isConfirmed(const GaussianUpdate& update, const Frame& frame, const WeightParticles& weight);
}  // namespace mrpt_ext
