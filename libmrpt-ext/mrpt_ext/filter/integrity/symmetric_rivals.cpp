#include "mrpt_ext/filter/integrity/symmetric_rivals.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/integrity/recovery_options.h"
#include "mrpt_ext/filter/particles/spaced_draws.h"
#include "mrpt_ext/geometry/log_probability.h"
#include "mrpt_ext/geometry/mahalanobis.h"
#include "mrpt_ext/likelihood/detection_density.h"
#include "mrpt_ext/likelihood/missed_detections.h"
#include "mrpt_ext/likelihood/sensor_bias.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kDraws = 8;     // of the pose under test, which is precise
constexpr double kMostOfFrame = 4.5;  // log-likelihood ratio of anonymous detections: no frame verifies alone
constexpr double kAroundMap = 3;      // [m] that a robot which was carried away may be outside
constexpr double kCarried = 0.01;     // share of the jumps of a mode in which the robot was carried, not slipping
constexpr double kWellWithin = 3;     // standard deviations of a pose
constexpr double kNearStds = 8;       // of a detection

/// A landmark in view of a draw.
struct LandmarkInView
{
  std::size_t landmark;
  LandmarkPrediction prediction;
  double share;  // of the detections
};

std::vector<LandmarkInView> inView(const Reading& reading, const LandmarkTable& map, const MissedLandmarks& history,
                                   const ParticleSet& draws, std::size_t draw)
{
  const Pose2 pose = draws.pose(draw);
  const SensorBias bias = sensorBias(draws.poses(), draw, reading.sensor);
  std::vector<LandmarkInView> result;
  for (std::size_t k = 0; k < map.size(); ++k)
  {
    LandmarkPrediction prediction = predict(map[k], reading, pose);
    if (!(prediction.visibility > 0)) continue;
    applyBias(prediction, bias);
    result.push_back({k, prediction, prediction.visibility * history.shareSeen(k)});
  }
  return result;
}

double totalShare(const std::vector<LandmarkInView>& landmarks)
{
  double sum = 0;
  for (const LandmarkInView& one : landmarks) sum += one.share;
  return sum;
}

/// Logarithm of the mean likelihood of the draws. `expected`: number of landmarks in view of each draw for each reading
/// by which the densities are divided. It is that of the pose under test for its rivals as well: a pose at the edge of
/// the map, with few landmarks in view, does not explain one of them better.
double logEvidence(const std::vector<Reading>& readings, const LandmarkTable& map, const MissedLandmarks& history,
                   const ParticleSet& draws, double max_range, std::vector<double>& expected)
{
  const bool first = expected.empty();
  double sum = kLogZero;
  for (std::size_t i = 0, next = 0; i < draws.size(); ++i)
  {
    double log_likelihood = 0;
    for (const Reading& reading : readings)
    {
      const std::vector<LandmarkInView> landmarks = inView(reading, map, history, draws, i);
      if (first) expected.push_back(std::max(1.0, totalShare(landmarks)));
      const double count = expected[next++], clutter = boundedClutter(reading.model.clutter_probability);
      for (const Detection& detection : reading.detections)
      {
        double density = clutter / measurementVolume(detection, reading.model, max_range);
        for (const LandmarkInView& one : landmarks)
          if (isWithin(detection, one.prediction, kNearStds) && mayShow(detection, map[one.landmark]))
            density += (1 - clutter) / count * one.share * std::exp(logDensity(detection, one.prediction));
        log_likelihood += std::log(density);
      }
    }
    sum = logSum(sum, log_likelihood);
  }
  return sum - std::log(static_cast<double>(draws.size()));
}

double logDensity(const GaussianPose& gaussian, const Pose2& pose)
{
  const double log_determinant = std::log(std::max(gaussian.covariance.determinant(), 1e-30));
  return -0.5 * (mahalanobis2(gaussian.mean, pose, gaussian.covariance) + log_determinant + 3 * std::log(kTwoPi));
}
}  // namespace

SymmetricRivals::SymmetricRivals(const LandmarkTable& map, double most) : most_(most), missed_(map.size(), kDraws)
{
  const auto [low, high] = map.boundingBox();
  const Vector2d extent = (high - low).array() + 2 * kAroundMap;
  log_density_anywhere_ = -std::log(extent.prod() * kTwoPi);
  for (MapSymmetry& symmetry : mapSymmetries(map))
    rivals_.push_back({std::move(symmetry), MissedLandmarks(map.size(), kDraws)});
}

double SymmetricRivals::bounded(double log_odds) const
{
  return std::isnan(log_odds) ? 0 : std::clamp(log_odds, -most_, most_);
}

void SymmetricRivals::start()
{
  forgetMissed();
  for (Rival& rival : rivals_) rival.log_odds = 0;
  rememberVerified();
}

void SymmetricRivals::leaveOutOf(const PoseRegion& region, const GaussianPose& now, const DeadReckoning& motion)
{
  const double std_turn = std::sqrt(now.covariance(2, 2) + motion.heading_variance);
  const double std_xy = std::sqrt(now.covariance(0, 0) + now.covariance(1, 1) + motion.walk_variance);
  const double margin = kWellWithin * (std_xy + std_turn * motion.pose.position().norm());
  PoseRegion wide = region;
  wide.low.array() -= margin;
  wide.high.array() += margin;
  wide.phi_low -= kWellWithin * std_turn;
  wide.phi_span += 2 * kWellWithin * std_turn;
  const Pose2 at_start = compose(now.mean, inverse(motion.pose));
  if (!wide.contains(at_start)) return;  // the robot was carried, or odometry errs by more than it is said to
  for (Rival& rival : rivals_)
    if (!wide.contains(compose(rival.symmetry.motion, at_start))) rival.log_odds = most_;
}

void SymmetricRivals::startAt(const GaussianPose& start, const Pose2& now)
{
  for (Rival& rival : rivals_)
  {
    const double image = logDensity(start, compose(rival.symmetry.motion, now));
    rival.log_odds = bounded(logDensity(start, now) - image);
  }
  rememberVerified();
}

void SymmetricRivals::accept()
{
  for (Rival& rival : rivals_) rival.log_odds = most_;
  rememberVerified();
}

void SymmetricRivals::rememberVerified()
{
  for (Rival& rival : rivals_) rival.log_odds_of_verified = rival.log_odds;
}

void SymmetricRivals::changeMode(const std::optional<GaussianPose>& before, const Pose2& now)
{
  forgetMissed();
  for (Rival& rival : rivals_) rival.log_odds = rival.log_odds_of_verified;
  if (!before) return;
  const GaussianPose slipped = afterSlip(*before);
  const double log_anywhere = std::log(kCarried) + log_density_anywhere_;
  for (Rival& rival : rivals_)
  {
    const Pose2& motion = rival.symmetry.motion;
    // The robot was at the verified pose, or at its rival; it is there still, or at the other one.
    const double odds = rival.log_odds_of_verified;
    const double log_right = -std::log1p(std::exp(-odds)), log_wrong = -std::log1p(std::exp(odds));
    const double stays = logDensity(slipped, now), to_rival = logDensity(slipped, compose(motion, now)),
                 from_rival = logDensity(slipped, compose(inverse(motion), now));
    const double here = logSum(logSum(log_right + stays, log_wrong + from_rival), log_anywhere);
    const double there = logSum(logSum(log_wrong + stays, log_right + to_rival), log_anywhere);
    rival.log_odds = bounded(here - there);
  }
}

void SymmetricRivals::useHeading(const CompassRecord& compass, const ParticleSet& particles)
{
  const ParticleSet draws = drawsFrom(particles);
  const auto log_density = [&](double turn)
  {
    double sum = 0;
    for (const float phi : draws.phi)
      sum -= square(wrap(compass.heading - double{phi} - turn) / compass.std_heading) / 2;
    return sum / static_cast<double>(std::max<std::size_t>(1, draws.size()));
  };
  for (Rival& rival : rivals_)
    rival.log_odds_of_heading = bounded(log_density(0) - log_density(rival.symmetry.motion.phi));
}

ParticleSet SymmetricRivals::drawsFrom(const ParticleSet& particles) const
{
  if (rivals_.empty() || particles.empty()) return particles.emptyLikeThis();
  return select(particles, spacedDraws(particles, kDraws));
}

void SymmetricRivals::update(const std::vector<Reading>& independent, const LandmarkTable& map,
                             const ParticleSet& draws)
{
  if (rivals_.empty() || independent.empty() || draws.empty()) return;
  const double max_range = defaultMaxRange(map);
  std::vector<double> expected;
  const double own = logEvidence(independent, map, missed_, draws, max_range, expected);
  const bool anonymous =
      std::any_of(independent.begin(), independent.end(), [](const Reading& reading) { return hasAnonymous(reading); });
  const double most = anonymous ? kMostOfFrame : most_;  // names tell at once, but one may be false
  for (Rival& rival : rivals_)
  {
    const double image = logEvidence(independent, rival.symmetry.image, rival.missed, draws, max_range, expected);
    rival.log_odds = bounded(rival.log_odds + std::clamp(own - image, -kMostOfFrame, most));
  }
}

void SymmetricRivals::look(const Reading& reading, const LandmarkTable& map, const ParticleSet& draws)
{
  if (rivals_.empty() || draws.empty()) return;
  const bool declared = scoresMissedDetections(reading);
  const double own = missed_.count(reading, map, draws);
  for (Rival& rival : rivals_)
  {
    const double image = rival.missed.count(reading, rival.symmetry.image, draws);
    if (declared) rival.log_odds = bounded(rival.log_odds + std::clamp(own - image, -kMostOfFrame, kMostOfFrame));
  }
}

void SymmetricRivals::doubt()
{
  forgetMissed();
  for (Rival& rival : rivals_) rival.log_odds = std::max(rival.log_odds, 0.0);
}

void SymmetricRivals::forgetMissed()
{
  missed_.clear();
  for (Rival& rival : rivals_) rival.missed.clear();
}

const SymmetricRivals::Rival* SymmetricRivals::strongestRival() const
{
  const auto least = std::min_element(rivals_.begin(), rivals_.end(),
                                      [](const Rival& a, const Rival& b) { return a.total() < b.total(); });
  return least == rivals_.end() ? nullptr : &*least;
}

double SymmetricRivals::logOdds() const
{
  const Rival* rival = strongestRival();
  return rival ? std::min(rival->total(), most_) : most_;
}

std::optional<Pose2> SymmetricRivals::strongest() const
{
  const Rival* rival = strongestRival();
  return rival ? std::optional(rival->symmetry.motion) : std::nullopt;
}
}  // namespace mrpt_ext
