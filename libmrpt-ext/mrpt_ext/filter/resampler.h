#pragma once

#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/filter/particle_filter_options.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// Resamples mode by mode (resampling.h), to a fixed or an adaptive number, and regularizes (regularization.h).
class Resampler
{
 public:
  explicit Resampler(const ParticleFilterOptions& options)
      : method_(options.resampling), adaptive_(options.adaptive_size), kld_(options.kld), threads_(options.threads)
  {
  }

  /// Normalised particles; `count` of a fixed size.
  void resample(ParticleSet& particles, const ModeSet& modes, std::size_t count, RandomStream& random);

 private:
  [[nodiscard]] std::size_t kldSize(const ParticleSet& particles, RandomStream& random) const;

  ResamplingMethod method_;
  bool adaptive_;
  KldOptions kld_;
  unsigned threads_;
  ParticleSet buffer_;  // reused by every resampling
};
}  // namespace mrpt_ext
