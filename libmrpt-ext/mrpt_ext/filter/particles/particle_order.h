#pragma once

#include "mrpt_ext/filter/particles/particle_set.h"

namespace mrpt_ext
{
/// Puts the particles in the order of a Z curve through position and heading (Morton 1966): what is close in memory is
/// close on the map. Likelihoods are computed for blocks of particles, and of a compact block all landmarks can be left
/// out but those near its detections.
void orderByPlace(ParticleSet& particles);
}  // namespace mrpt_ext
