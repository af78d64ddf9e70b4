#pragma once

#include <vector>

#include "mrpt_ext/filter/particles/particle_set.h"

namespace mrpt_ext
{
/// Indices of `draws_wanted` evenly spaced draws from the normalised particles, none without particles. Deterministic,
/// so that what is estimated with them costs no random numbers. `threads` change nothing but the time.
[[nodiscard]] std::vector<std::size_t> spacedDraws(const ParticleSet& particles, std::size_t draws_wanted,
                                                   unsigned threads = 1);
}  // namespace mrpt_ext
