#pragma once

#include <functional>

#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// Sets the log weights to the logarithm of the posterior density at the particles, up to a constant; minus infinity
/// where it is zero. Systematic errors of sensors count with their prior, see addBiasLogPrior().
using LogPosterior = std::function<void(ParticleSet&)>;

/// Moves every particle by steps that leave the posterior as it is (resample-move: Gilks and Berzuini, J. R. Stat. Soc.
/// B 63(1), 2001; the steps: Metropolis), so that copies of few ancestors become as many draws again. Particles that
/// nothing but motion tells apart, as the headings of a robot at standstill that knows ranges alone, would die out one
/// after the other although no measurement speaks against them: which are left is chance, and the right one may not be.
///
/// Steps alternate between a random walk in pose and systematic errors of the sensors, as wide and as correlated as the
/// mode that the particle belongs to, and a turn to any heading about `pivot` [m, robot frame], which keeps the middle
/// of the places that were measured from; as many as it takes until the modes no longer grow. Systematic errors of
/// odometry and the weights stay.
void moveByPosterior(ParticleSet& particles, const ModeSet& modes, const Vector2d& pivot, const LogPosterior& posterior,
                     RandomStream& random);

/// Adds the logarithm of the prior density of the systematic errors of the sensors to the log weights.
void addBiasLogPrior(ParticleSet& particles);
}  // namespace mrpt_ext
