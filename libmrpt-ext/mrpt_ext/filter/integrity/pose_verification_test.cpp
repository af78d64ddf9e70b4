#include "mrpt_ext/filter/integrity/pose_verification_test.h"

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

bool isNamelessBearing(const Detection& d) { return d.id == kNoId && d.bearing && !d.range; }
}  // namespace

SequentialPoseTest::SequentialPoseTest(const SequentialPoseTestOptions& options, const MotionModel& motion,
                                       const LandmarkTable& map)
    : options_(options), looks_(options.looks, motion, map), mapless_(motion, defaultMaxRange(map))
{
}

void SequentialPoseTest::note(const Frame& frame)
{
  move(frame.motion);
  decayAfterGap(frame);
  for (const Reading& reading : scoredReadings(frame)) (void)logChance(looks_.take(reading), 1);
}

void SequentialPoseTest::move(const OdometryMotion& motion)
{
  looks_.move(motion);
  mapless_.move(motion);
  blind_for_ += motion.duration;
}

void SequentialPoseTest::decayAfterGap(const Frame& frame)
{
  const auto any = [&](auto&& is)
  {
    return std::any_of(frame.readings.begin(), frame.readings.end(),
                       [&](const Reading& reading)
                       { return std::any_of(reading.detections.begin(), reading.detections.end(), is); });
  };
  if (!any([](const Detection&) { return true; })) return;
  const double forgotten = options_.decay_per_s * std::max(0.0, blind_for_ - options_.decay_after);
  blind_for_ = 0;
  if (log_odds_ > 0 && !any([](const Detection& d) { return d.id != kNoId; }))
    log_odds_ = std::max(0.0, log_odds_ - forgotten);
}

double SequentialPoseTest::logChance(const Reading& looks, double default_max_range)
{
  double sum = 0;
  for (const Detection& d : looks.detections)
    sum += isNamelessBearing(d) ? mapless_.take(looks, d)
                                : -std::log(measurementVolume(d, looks.model, default_max_range));
  return sum;
}

void SequentialPoseTest::begin(const std::vector<Reading>& readings, const LandmarkTable& map,
                               const ParticleSet& samples)
{
  looks_.clear();
  mapless_.clear();
  ParticleSet particles = samples;
  log_odds_ =
      normalizeWeights(particles).log_sum - std::log(static_cast<double>(std::max<std::size_t>(1, samples.size())));
  test(readings, map, std::move(particles));
  log_odds_ = std::min(log_odds_, options_.proven / 2);
}

void SequentialPoseTest::observe(const Frame& frame, const LandmarkTable& map, const ParticleSet& moved_particles)
{
  move(frame.motion);
  decayAfterGap(frame);
  test(scoredReadings(frame), map, thinned(moved_particles));
}

void SequentialPoseTest::test(const std::vector<Reading>& readings, const LandmarkTable& map, ParticleSet particles)
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
