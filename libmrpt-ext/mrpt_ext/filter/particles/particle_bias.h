#pragma once

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// Draws the systematic errors of the particles from `first` on from what is known about them at the start.
void drawBiases(ParticleSet& particles, std::size_t first, RandomStream& random);

/// The random walk of the systematic errors over `duration` [s].
void walkBiases(ParticleSet& particles, double duration, RandomStream& random);
}  // namespace mrpt_ext
