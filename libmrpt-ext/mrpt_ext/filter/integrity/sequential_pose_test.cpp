#include "mrpt_ext/filter/integrity/sequential_pose_test.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/integrity/sensor_monitors.h"
#include "mrpt_ext/filter/kalman/kalman_association.h"
#include "mrpt_ext/filter/particle_moments.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/facing_likelihood.h"
#include "mrpt_ext/likelihood/reading_scorer.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMaxScored = 4000;  // particles: enough to estimate a density
constexpr double kClearlyLikelier = 0.5;  // of the probability of all landmarks

/// Every k-th particle, at most kMaxScored of them, normalised.
ParticleSet thinned(const ParticleSet& particles)
{
  const std::size_t stride = (particles.size() + kMaxScored - 1) / kMaxScored;
  ParticleSet few = particles.emptyLikeThis();
  for (std::size_t i = 0; i < particles.size(); i += stride) few.addCopy(particles, i, double{particles.log_weight[i]});
  normalizeWeights(few);
  return few;
}

/// The detections of a reading one by one.
std::vector<Reading> parts(const Reading& reading)
{
  std::vector<Reading> result(reading.detections.size(), reading);
  for (std::size_t k = 0; k < result.size(); ++k) result[k].detections = {reading.detections[k]};
  return result;
}

/// Index of the landmark that the only detection shows if it is no clutter; nothing where two are nearly as likely.
std::optional<std::size_t> landmarkIn(const Reading& part, const LandmarkTable& map, const KalmanState& state)
{
  const Detection& detection = part.detections.front();
  if (detection.id != kNoId) return map.indexOf(detection.id);
  const Association found = associate(detection, part, map, state, {}, defaultMaxRange(map));
  return found.best > kClearlyLikelier * found.inlier_probability ? std::optional(found.landmark) : std::nullopt;
}

/// An anonymous range or bearing alone fits so many landmarks that none can be told to be seen again, and so many poses
/// that those right about one landmark are not the strongest rivals.
bool tellsPlace(const Detection& detection) { return detection.range && detection.bearing; }

/// True when a landmark is seen to face in a direction that leaves one heading.
bool showsHeading(const Reading& reading, const LandmarkTable& map)
{
  const auto leaves_one = [&](const Detection& detection)
  {
    const auto headings = headingFromFacing(detection, reading, map);
    return headings && headings->attitudes.front().weight >= kCertainAttitude;
  };
  return std::any_of(reading.detections.begin(), reading.detections.end(), leaves_one);
}
}  // namespace

SequentialPoseTest::SequentialPoseTest(const MotionModel& motion, const LandmarkTable& map)
    : decorrelator_(motion, map),
      null_model_(motion, defaultMaxRange(map)),
      point_null_model_(motion, defaultMaxRange(map)),
      spot_(motion, decorrelationDistance(map))
{
}

void SequentialPoseTest::skip(const Frame& frame)
{
  move(frame.motion);
  decayAfterGap(frame);
  for (const Reading& reading : scoredReadings(frame))
  {
    for (const Reading& part : parts(decorrelator_.independent(reading))) (void)observeWithoutMap(part, 1);
    if (hasAnonymous(reading)) (void)spot_.isFirstOf(sensorKey(reading));
  }
}

void SequentialPoseTest::move(const OdometryMotion& motion)
{
  decorrelator_.move(motion);
  null_model_.move(motion);
  point_null_model_.move(motion);
  if (spot_.move(motion)) decorrelator_.clear();
  gap_ += motion.duration;
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
  const double decay = kDecayPerS * std::max(0.0, gap_ - kDecayAfter);
  gap_ = 0;
  if (log_odds_ > 0 && !any([](const Detection& d) { return d.id != kNoId; }))
    log_odds_ = std::max(0.0, log_odds_ - decay);
}

FeatureMixture::Outcome SequentialPoseTest::observeWithoutMap(const Reading& part, double default_max_range)
{
  const Detection& d = part.detections.front();
  if (d.id != kNoId || !d.bearing) return {-std::log(measurementVolume(d, part.model, default_max_range))};
  return d.range ? point_null_model_.observe(part, d) : null_model_.observe(part, d);
}

void SequentialPoseTest::start(const std::vector<Reading>& readings, const LandmarkTable& map,
                               const ParticleSet& samples)
{
  reset();
  decorrelator_.clear();
  null_model_.clear();
  point_null_model_.clear();
  ParticleSet particles = samples;
  log_odds_ =
      normalizeWeights(particles).log_sum - std::log(static_cast<double>(std::max<std::size_t>(1, samples.size())));
  test(readings, map, std::move(particles));
  log_odds_ = std::min(log_odds_, kAcceptLogOdds / 2);
}

void SequentialPoseTest::update(const Frame& frame, const LandmarkTable& map, const ParticleSet& predicted)
{
  move(frame.motion);
  decayAfterGap(frame);
  heading_measured_ = heading_measured_ || frame.compass;
  test(scoredReadings(frame), map, thinned(predicted));
}

void SequentialPoseTest::test(const std::vector<Reading>& readings, const LandmarkTable& map, ParticleSet particles)
{
  const LandmarkClutter clutter;
  for (const Reading& reading : readings)
  {
    const Reading independent = decorrelator_.independent(reading);
    heading_seen_ = heading_seen_ || showsHeading(reading, map);
    if (independent.detections.empty()) continue;
    const bool first = !hasAnonymous(reading) || spot_.isFirstOf(sensorKey(reading));
    const auto state = momentsOf(particles, [](std::size_t) { return true; });
    for (const Reading& part : parts(independent))
    {
      const FeatureMixture::Outcome without_map = observeWithoutMap(part, defaultMaxRange(map));
      const auto landmark = state ? landmarkIn(part, map, startingState(state->gaussianPose(), {})) : std::nullopt;
      // What a tracked feature is was seen before.
      if (landmark && without_map.is_known) seen_.add(*landmark);
      if (hasAnonymous(part) && tellsPlace(part.detections.front()))
      {
        seen_.score(part, map, particles.origin, particles.poses(), particles.log_weight);
        seen_.count(landmark);
      }
      else
        ReadingScorer(part, map, clutter, particles.origin).addTo(particles.poses(), particles.log_weight);
      const double log_ratio = normalizeWeights(particles).log_sum - without_map.log_density;
      log_odds_ = std::min(log_odds_ + counted(part, landmark, log_ratio, first), kMaxLogOdds);
    }
  }
}

double SequentialPoseTest::counted(const Reading& part, std::optional<std::size_t> landmark, double log_ratio,
                                   bool first)
{
  if (hasAnonymous(part)) log_ratio = spot_.counted(std::min(log_ratio, kMaxLogOdds - log_odds_), first);
  if (!landmark || (hasAnonymous(part) && !tellsPlace(part.detections.front()))) return log_ratio;
  const double against_rivals = by_landmark_.add(*landmark, log_ratio);
  if (log_odds_ <= 0) rivals_refuted_ = false;
  if (verified() || heading_measured_ || heading_seen_) rivals_refuted_ = true;
  return rivals_refuted_ ? log_ratio : against_rivals;
}
}  // namespace mrpt_ext
