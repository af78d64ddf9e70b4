#pragma once

#include "mrpt_ext/filter/particle_moments.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// Adds the log-likelihood of a frame to the log weights of particles.
using WeightParticles = std::function<void(const Frame&, ParticleSet&)>;

/// Draws particles from a proposal that uses the newest measurement. It helps where few particles from the motion model
/// alone would survive a precise measurement.
///
/// `prior` is the Gaussian of one mode's particles after the motion; `posterior` is its iterated Kalman update. 90 % of
/// the particles come from the posterior with standard deviations larger by a factor, the rest from the prior, which
/// bounds the weights. Every weight is prior density over proposal density. Weighted with the likelihood of the frame,
/// the particles represent the exact posterior of a Gaussian prior, clutter included (Gaussian particle filter: Kotecha
/// and Djuric, IEEE Trans. Signal Process. 51(10), 2003; defensive mixture: Hesterberg, Technometrics 37(2), 1995).
[[nodiscard]] ParticleSet drawFromKalmanProposal(const ParticleSet& like, const KalmanState& prior,
                                                 const KalmanState& posterior, std::size_t count, double inflation,
                                                 RandomStream& random);

/// A Kalman proposal is tried when the effective sample size is below both limits.
struct KalmanProposalLimits
{
  std::size_t effective = 0;   ///< effective particles
  double effective_ratio = 0;  ///< ... relative to the number of particles
};

/// Replaces weighted particles by as many from a Kalman proposal, if their effective sample size is below the limits
/// and that of the new ones is larger. `prior`: Gaussian of the only mode, after the motion and before weighting.
/// `weight` weights the new particles with the same frame. Normalises the particles.
void proposeFromKalman(ParticleSet& particles, const KalmanState& prior, const Frame& frame, const LandmarkTable& map,
                       const KalmanProposalLimits& limits, const WeightParticles& weight, RandomStream& random);
}  // namespace mrpt_ext
