#include "mrpt_ext/filter/resampler.h"

#include <algorithm>
#include <utility>

#include "mrpt_ext/filter/regularization.h"
#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kCostOfDraw = 60;  // of a particle, in operations (work_counter.h)
}  // namespace

std::size_t Resampler::kldSize(const ParticleSet& particles, RandomStream& random) const
{
  // The bins that a resampled set of the present size would occupy (Fox 2003).
  const std::vector<std::size_t> trial = drawIndices(method_, weights(particles), particles.size(), random);
  const double needed = kldSampleSize(occupiedBins(select(particles, trial), kld_), kld_.epsilon, kld_.delta);
  return static_cast<std::size_t>(
      std::clamp(needed, static_cast<double>(kld_.min_size), static_cast<double>(kld_.max_size)));
}

void Resampler::resample(ParticleSet& particles, const ModeSet& modes, std::size_t count, RandomStream& random)
{
  WorkCounter::add(kCostOfDraw * (particles.size() + count));
  if (adaptive_) count = kldSize(particles, random);
  ParticleSet drawn = resampleByMode(particles, modes.mode_of, method_, count, random, threads_, std::move(buffer_));
  buffer_ = std::exchange(particles, std::move(drawn));
  regularizeModes(particles, modes, {}, random, threads_);
}
}  // namespace mrpt_ext
