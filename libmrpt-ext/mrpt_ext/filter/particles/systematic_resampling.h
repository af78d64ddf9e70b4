#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// How many of `count` draws each of some weights of positive sum gets: its expected number, rounded up or down.
[[nodiscard]] std::vector<std::size_t> allotSystematically(const std::vector<double>& weights, std::size_t count,
                                                           RandomStream& random);

/// resampleByMode() for the systematic method without a list of indices: the sums of all blocks
/// before it determine which points fall on a block of particles, and it copies its survivors to their final positions,
/// mode after mode. `buffer` is reused for the result. Returns nothing if there are too many modes for sums per block
/// and mode, or if no weight is positive.
[[nodiscard]] std::optional<ParticleSet> resampleSystematically(const ParticleSet& particles,
                                                                const std::vector<int>& mode_of, std::size_t count,
                                                                RandomStream& random, unsigned threads,
                                                                ParticleSet buffer = {});
}  // namespace mrpt_ext
