#pragma once

#include <vector>

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// MRPT's four methods, by its names prMultinomial, prResidual, prStratified, prSystematic.
enum class ResamplingMethod
{
  multinomial,
  residual,
  stratified,
  systematic
};

/// `count` indices drawn with probabilities `weights` (need not sum to 1): each index i is expected
/// count * weights[i] / sum times. Ascending order, except for what the residual method draws last.
[[nodiscard]] std::vector<std::size_t> drawIndices(ResamplingMethod method, const std::vector<double>& weights,
                                                   std::size_t count, RandomStream& random);

/// Resamples every mode by itself, so that equal modes keep their weights instead of drifting apart by chance (global
/// resampling makes the share of two equal modes a random walk). `mode_of[i]` numbers the mode of particle i from 0.
/// A mode of weight w gets about count * w particles, each of weight w / its number. A mode with count * w < 1 gets one
/// particle of weight 1 / count with probability count * w, else none: its expected weight is kept as well.
/// The result does not depend on `threads`. `buffer` is reused for it.
[[nodiscard]] ParticleSet resampleByMode(const ParticleSet& particles, const std::vector<int>& mode_of,
                                         ResamplingMethod method, std::size_t count, RandomStream& random,
                                         unsigned threads = 1, ParticleSet buffer = {});
}  // namespace mrpt_ext
