#include "mrpt_ext/filter/integrity/sequential_pose_test.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mrpt_ext/filter/integrity/sensor_monitors.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/facing_likelihood.h"
#include "mrpt_ext/likelihood/landmark_prediction.h"
#include "mrpt_ext/likelihood/missed_detections.h"
#include "mrpt_ext/likelihood/reading_scorer.h"
#include "mrpt_ext/likelihood/running_fix_likelihood.h"
#include "mrpt_ext/likelihood/sensor_bias.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kMaxScored = 4000;  // particles: enough to estimate a density
constexpr double kClearlyNearer = 0.5;    // times the distance of the second landmark

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

/// The nearest landmark and the distance of the second.
class NearestOfTwo
{
 public:
  void add(std::size_t landmark, double distance)
  {
    if (distance < nearest_) best_ = landmark;
    second_ = std::min(second_, std::max(nearest_, distance));
    nearest_ = std::min(nearest_, distance);
  }
  /// Nothing where the second is nearly as near.
  [[nodiscard]] std::optional<std::size_t> clear() const
  {
    return nearest_ < kClearlyNearer * second_ ? std::optional(best_) : std::nullopt;
  }

 private:
  double nearest_ = std::numeric_limits<double>::infinity(), second_ = nearest_;
  std::size_t best_ = 0;
};

/// Where the only detection, with range and bearing, is in the map: the mean over the particles.
Vector2d placeOf(const Reading& part, const ParticleSet& particles)
{
  const Detection& detection = part.detections.front();
  const Vector2d by_sensor = *detection.range * Vector2d(std::cos(*detection.bearing), std::sin(*detection.bearing));
  const Vector2d by_robot = part.T_robot_sensor.position() + rotation(part.T_robot_sensor.phi) * by_sensor;
  Vector2d sum = Vector2d::Zero();
  double weights = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const Pose2 pose = particles.pose(i);
    const double weight = std::exp(double{particles.log_weight[i]});
    sum += weight * (pose.position() + rotation(pose.phi) * by_robot);
    weights += weight;
  }
  return weights > 0 ? Vector2d(sum / weights) : sum;
}

/// Index of the landmark that the only detection shows if it is no clutter. Nothing where another is nearly as near,
/// and for an anonymous range or bearing.
std::optional<std::size_t> landmarkIn(const Reading& part, const LandmarkTable& map, const ParticleSet& particles)
{
  const Detection& detection = part.detections.front();
  if (detection.id != kNoId) return map.indexOf(detection.id);
  // An anonymous range or bearing alone fits so many poses that those right about one landmark are not the strongest
  // rivals.
  if (!detection.range || !detection.bearing) return std::nullopt;
  const Vector2d place = placeOf(part, particles);
  NearestOfTwo nearest;
  for (std::size_t k = 0; k < map.size(); ++k) nearest.add(k, (map[k].position.head<2>() - place).norm());
  return nearest.clear();
}

/// Index of the landmark that the only detection, an anonymous bearing, shows if it is no clutter, seen from the
/// heaviest particle. Nothing where another one in view is nearly as near.
std::optional<std::size_t> landmarkInDirection(const Reading& part, const LandmarkTable& map,
                                               const ParticleSet& particles)
{
  if (particles.size() == 0) return std::nullopt;
  const Detection& detection = part.detections.front();
  const auto first = particles.log_weight.begin();
  const auto heaviest = static_cast<std::size_t>(std::max_element(first, particles.log_weight.end()) - first);
  const Pose2 pose = particles.pose(heaviest);
  const SensorBias bias = sensorBias(particles.poses(), heaviest, part.sensor);
  NearestOfTwo nearest;
  for (std::size_t k = 0; k < map.size(); ++k)
  {
    if (!mayShow(detection, map[k])) continue;
    LandmarkPrediction prediction = predict(map[k], part, pose);
    applyBias(prediction, bias);
    if (prediction.visibility > 0) nearest.add(k, std::abs(wrap(*detection.bearing - prediction.bearing)));
  }
  return nearest.clear();
}

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
      slip_(motion, defaultMaxRange(map)),
      missed_(map.size()),
      spot_(motion, decorrelationDistance(map)),
      symmetric_(map, kMaxLogOdds)
{
}

void SequentialPoseTest::skip(const Frame& frame)
{
  move(frame.motion);
  decayAfterGap(frame);
  for (const Reading& reading : scoredReadings(frame))
  {
    const auto [independent, correlated] = decorrelator_.split(reading);
    for (const Reading& part : parts(independent))
    {
      (void)null_model_.observe(part);
      slip_.skip(part);
    }
    track(correlated);
    const std::string sensor = sensorKey(reading);
    spot_.count(sensor, reading.detections.size(), independent.detections.size());
    if (hasAnonymous(reading)) (void)spot_.isFirstOf(sensor);
  }
}

void SequentialPoseTest::move(const OdometryMotion& motion)
{
  decorrelator_.move(motion);
  null_model_.move(motion);
  slip_.move(motion);
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

void SequentialPoseTest::endGap(const OdometryMotion& motion)
{
  log_odds_ = -std::log(std::exp(-log_odds_) + SlipTest::kSlipRate * (gap_ + motion.duration));
  by_landmark_.restart(true);
  rivals_refuted_ = heading_seen_ = false;
}

void SequentialPoseTest::track(const Reading& correlated)
{
  null_model_.track(correlated);
  slip_.track(correlated);
}

void SequentialPoseTest::start(const std::vector<Reading>& readings, const LandmarkTable& map,
                               const ParticleSet& samples)
{
  reset();
  decorrelator_.clear();
  null_model_.clear();
  ParticleSet particles = samples;
  log_odds_ =
      normalizeWeights(particles).log_sum - std::log(static_cast<double>(std::max<std::size_t>(1, samples.size())));
  test(readings, map, std::move(particles));
  symmetric_.start();
  log_odds_ = std::min(log_odds_, kAcceptLogOdds / 2);
}

void SequentialPoseTest::update(const Frame& frame, const LandmarkTable& map, const ParticleSet& predicted)
{
  move(frame.motion);
  decayAfterGap(frame);
  heading_measured_ = heading_measured_ || frame.compass;
  if (frame.compass) symmetric_.useHeading(*frame.compass, predicted);
  test(scoredReadings(frame), map, thinned(predicted));
}

void SequentialPoseTest::test(const std::vector<Reading>& readings, const LandmarkTable& map, ParticleSet particles)
{
  const ParticleSet draws = symmetric_.drawsFrom(particles);
  std::vector<Reading> all_independent;
  std::vector<Reading> all_correlated;
  std::vector<const Reading*> looks;
  for (const Reading& reading : readings)
  {
    auto [independent, correlated] = decorrelator_.split(reading);
    heading_seen_ = heading_seen_ || showsHeading(reading, map);
    const std::string sensor = sensorKey(reading);
    Spot spot{false, spot_.shareOfNew(sensor)};
    spot_.count(sensor, reading.detections.size(), independent.detections.size());
    if (!independent.detections.empty())
    {
      spot.first = hasAnonymous(reading) && spot_.isFirstOf(sensor);
      for (const Reading& part : parts(independent)) testDetection(part, map, particles, spot);
      all_independent.push_back(std::move(independent));
    }
    all_correlated.push_back(std::move(correlated));
    if (!spot.first) continue;
    if (scoresMissedDetections(reading)) log_odds_ += missed_.count(reading, map, particles);
    looks.push_back(&reading);
  }
  for (const Reading& correlated : all_correlated) track(correlated);
  symmetric_.update(all_independent, map, draws);
  for (const Reading* reading : looks) symmetric_.look(*reading, map, draws);
}

void SequentialPoseTest::testDetection(const Reading& part, const LandmarkTable& map, ParticleSet& particles,
                                       const Spot& spot)
{
  const FeatureMixture::Outcome without_map = null_model_.observe(part);
  const std::optional<std::size_t> landmark = landmarkIn(part, map, particles);
  // A feature that the null model recognizes is a landmark that was seen before.
  if (landmark && without_map.isKnown()) seen_.add(*landmark);
  const bool is_feature = hasAnonymous(part) && part.detections.front().bearing;
  if (is_feature)
  {
    seen_.score(part, map, particles.origin, particles.poses(), without_map, particles.log_weight);
    // Which landmark a bearing shows is chosen by the bearing itself, so it was seen only from now on.
    const auto shown = part.detections.front().range ? landmark : landmarkInDirection(part, map, particles);
    if (shown) seen_.add(*shown);
  }
  else
    ReadingScorer(part, map, LandmarkClutter{}, particles.origin).addTo(particles.poses(), particles.log_weight);
  const double log_density = normalizeWeights(particles).log_sum;
  slip_.count(part, log_density);
  double log_ratio = log_density - without_map.log_density;
  if (is_feature) log_ratio = strays_[sensorKey(part)].counted(log_ratio, part.model);
  log_odds_ = std::min(log_odds_ + counted(part, landmark, log_ratio, spot), kMaxLogOdds);
}

double SequentialPoseTest::counted(const Reading& part, std::optional<std::size_t> landmark, double log_ratio,
                                   const Spot& spot)
{
  if (hasAnonymous(part))
    log_ratio = spot_.counted(std::min(log_ratio, kMaxLogOdds - log_odds_), spot.first);
  else
    log_ratio = againstRepetition(log_ratio, spot.share_of_new, boundedClutter(part.model.clutter_probability));
  if (!landmark) return log_ratio;
  const double against_rivals = by_landmark_.add(*landmark, log_ratio);
  if (log_odds_ <= 0) rivals_refuted_ = false;
  if (log_odds_ >= kAcceptLogOdds || heading_measured_ || heading_seen_) rivals_refuted_ = true;
  return rivals_refuted_ ? log_ratio : against_rivals;
}
}  // namespace mrpt_ext
