#pragma once

#include "mrpt_ext/filter/particle_moments.h"

namespace mrpt_ext
{
/// Particles drawn where a sharp measurement has put the posterior, for the case that few of those drawn by the motion
/// model alone would survive it.
///
/// `prior` stands for the moved particles of a robot that is at one place, `posterior` for what an iterated Kalman
/// update makes of it. Nine tenths are drawn from the posterior (its deviations widened by a fifth), the rest from the
/// prior, which bounds the weights; every weight is prior density over density drawn from, so that scoring them with
/// the frame's likelihood gives the exact posterior of a Gaussian prior, false readings and all (Gaussian particle
/// filter: Kotecha and Djuric, IEEE Trans. Signal Process. 51(10), 2003; defensive mixture: Hesterberg, Technometrics
/// 37(2), 1995).
[[nodiscard]] ParticleSet drawFromKalmanProposal(const ParticleSet& like, const KalmanState& prior,
                                                 const KalmanState& posterior, std::size_t count, RandomStream& random);
}  // namespace mrpt_ext
