#pragma once

#include "mrpt_ext/filter/particle_moments.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"

namespace mrpt_ext
{
/// Adds the log-likelihood of a frame to the log weights of particles.
using WeightParticles = std::function<void(const Frame&, ParticleSet&)>;

/// Particles drawn where a precise measurement has put the posterior, for the case that few of those drawn by the
/// motion model alone would survive it.
///
/// `prior` represents the moved particles of one mode, `posterior` is its iterated Kalman update. Nine tenths are drawn
/// from the posterior (standard deviations 20 % wider), the rest from the prior, which bounds the weights. Every weight
/// is prior density over proposal density, so that weighting them with the frame's likelihood gives the exact posterior
/// of a Gaussian prior, clutter included (Gaussian particle filter: Kotecha and Djuric, IEEE Trans. Signal Process.
/// 51(10), 2003; defensive mixture: Hesterberg, Technometrics 37(2), 1995).
[[nodiscard]] ParticleSet drawFromKalmanProposal(const ParticleSet& like, const KalmanState& prior,
                                                 const KalmanState& posterior, std::size_t count, RandomStream& random);

/// Effective particles below which a Kalman proposal is tried.
struct KalmanProposalLimits
{
  std::size_t effective = 0;
  double effective_ratio = 0;
};

/// Replaces weighted particles, where fewer are effective than both limits, by as many from a Kalman proposal, if more
/// of those are effective. `prior`: the particles of the only mode before weighting. `weight` weights the new ones with
/// the same frame. Normalises the particles.
void proposeFromKalman(ParticleSet& particles, const KalmanState& prior, const Frame& frame, const LandmarkTable& map,
                       const KalmanProposalLimits& limits, const WeightParticles& weight, RandomStream& random);
}  // namespace mrpt_ext
