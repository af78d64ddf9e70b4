#include "mrpt_ext/filter/place_evidence.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/reading_scorer.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMostScored = 4000;  // particles: enough to tell a density

/// Every k-th particle, at most kMostScored of them, normalised.
ParticleSet thinned(const ParticleSet& particles)
{
  const std::size_t stride = (particles.size() + kMostScored - 1) / kMostScored;
  ParticleSet few = particles.emptyLikeThis();
  for (std::size_t i = 0; i < particles.size(); i += stride) few.addCopy(particles, i, double{particles.log_weight[i]});
  normalizeWeights(few);
  return few;
}

double logChance(const Reading& reading, double default_max_range)
{
  double sum = 0;
  for (const Detection& d : reading.detections) sum -= std::log(measurementVolume(d, reading.model, default_max_range));
  return sum;
}
}  // namespace

PlaceEvidence::PlaceEvidence(const PlaceEvidenceOptions& options, const MotionModel& motion, const LandmarkTable& map)
    : options_(options), looks_(options.looks, motion, map)
{
}

void PlaceEvidence::note(const Frame& frame)
{
  looks_.move(frame.motion);
  for (const Reading& reading : scoredReadings(frame)) (void)looks_.take(reading);
}

void PlaceEvidence::begin(const std::vector<Reading>& readings, const LandmarkTable& map, const ParticleSet& samples)
{
  looks_.clear();
  ParticleSet particles = samples;
  log_odds_ =
      normalizeWeights(particles).log_sum - std::log(static_cast<double>(std::max<std::size_t>(1, samples.size())));
  test(readings, map, std::move(particles));
  log_odds_ = std::min(log_odds_, options_.proven / 2);
}

void PlaceEvidence::observe(const Frame& frame, const LandmarkTable& map, const ParticleSet& moved_particles)
{
  looks_.move(frame.motion);
  test(scoredReadings(frame), map, thinned(moved_particles));
}

void PlaceEvidence::test(const std::vector<Reading>& readings, const LandmarkTable& map, ParticleSet particles)
{
  const LandmarkClutter clutter;
  for (const Reading& reading : readings)
  {
    const Reading looks = looks_.take(reading);
    if (looks.detections.empty()) continue;
    const ReadingScorer scorer(looks, map, clutter, particles.origin);
    scorer.addTo(particles.poses(), particles.log_weight);
    log_odds_ += normalizeWeights(particles).log_sum - logChance(looks, defaultMaxRange(map));
  }
  log_odds_ = std::min(log_odds_, options_.most);
}
}  // namespace mrpt_ext
