#include "mrpt_ext/filter/place_evidence.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/reading_scorer.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMostScored = 4000;       // particles: enough to tell a density
constexpr double kSameDirection = degToRad(6);  // for parallax over a piece of way and odometry's error
constexpr double kGate = 3;                     // standard deviations

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
    : options_(options), motion_(motion), look_way_(options.longest_look)
{
  if (map.size() < 2) return;
  const auto [low, high] = map.boundingBox();
  look_way_ = std::min(look_way_, options.look_share * (high - low).norm());
}

void PlaceEvidence::move(const OdometryMotion& motion)
{
  odometry_ = compose(odometry_, believedMotion(motion_, motion).increment);
  heading_variance_ += incrementCovariance(motion_, motion)(2, 2);
  std::erase_if(looks_, [&](const Look& look) { return (look.from - odometry_.position()).norm() > look_way_; });
}

bool PlaceEvidence::isRepeat(const Look& look) const
{
  const auto same = [&](const Look& other)
  {
    const Detection &a = look.detection, &b = other.detection;
    if (look.sensor != other.sensor || a.id != b.id || a.category != b.category) return false;
    if (a.bearing.has_value() != b.bearing.has_value() || a.range.has_value() != b.range.has_value()) return false;
    const double turned = look.heading_variance - other.heading_variance;
    const double bearing_gate =
        kSameDirection + kGate * std::sqrt(square(a.std_bearing) + square(b.std_bearing) + turned);
    if (a.bearing && std::abs(wrap(look.direction - other.direction)) > bearing_gate) return false;
    const double range_gate = look_way_ + kGate * std::hypot(a.std_range, b.std_range);
    return a.id != kNoId || !a.range || std::abs(*a.range - *b.range) <= range_gate;
  };
  return std::any_of(looks_.begin(), looks_.end(), same);
}

Reading PlaceEvidence::fresh(const Reading& reading)
{
  Reading result = reading;
  result.detections.clear();
  result.model.detection_probability.reset();  // what was missed is told by whole readings only
  const std::size_t known = looks_.size();
  std::vector<Look> added;
  for (const Detection& detection : reading.detections)
  {
    Look look{reading.sensor, detection, odometry_.position(), 0, heading_variance_};
    if (detection.bearing) look.direction = odometry_.phi + reading.T_robot_sensor.phi + *detection.bearing;
    if (isRepeat(look)) continue;
    result.detections.push_back(detection);
    added.push_back(std::move(look));
  }
  looks_.reserve(known + added.size());
  std::move(added.begin(), added.end(), std::back_inserter(looks_));
  return result;
}

void PlaceEvidence::note(const Frame& frame)
{
  move(frame.motion);
  for (const Reading& reading : scoredReadings(frame)) (void)fresh(reading);
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
  move(frame.motion);
  test(scoredReadings(frame), map, thinned(moved_particles));
}

void PlaceEvidence::test(const std::vector<Reading>& readings, const LandmarkTable& map, ParticleSet particles)
{
  const LandmarkClutter clutter;
  for (const Reading& reading : readings)
  {
    const Reading looks = fresh(reading);
    if (looks.detections.empty()) continue;
    const ReadingScorer scorer(looks, map, clutter, particles.origin);
    scorer.addTo(particles.poses(), particles.log_weight);
    log_odds_ += normalizeWeights(particles).log_sum - logChance(looks, defaultMaxRange(map));
  }
  log_odds_ = std::min(log_odds_, options_.most);
}
}  // namespace mrpt_ext
