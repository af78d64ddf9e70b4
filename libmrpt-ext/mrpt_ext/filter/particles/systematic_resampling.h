#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// resampleByMode() for the systematic method without a list of indices: every block of particles knows from the sums
/// of the blocks before it which points fall on its own, and copies its survivors to their places, mode after mode.
/// `memory` is used for the result, whatever it holds. Nothing when the modes are too many for sums per block and mode,
/// or when no weight is positive.
[[nodiscard]] std::optional<ParticleSet> resampleSystematically(const ParticleSet& particles,
                                                                const std::vector<int>& mode_of, std::size_t count,
                                                                RandomStream& random, unsigned threads,
                                                                ParticleSet memory = {});
}  // namespace mrpt_ext
