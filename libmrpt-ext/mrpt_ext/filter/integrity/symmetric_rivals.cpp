#include "mrpt_ext/filter/integrity/symmetric_rivals.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/integrity/recovery_options.h"
#include "mrpt_ext/filter/particles/spaced_draws.h"
#include "mrpt_ext/geometry/log_probability.h"
#include "mrpt_ext/geometry/mahalanobis.h"
#include "mrpt_ext/likelihood/reading_scorer.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kDraws = 64;    // of the pose under test
constexpr double kMostOfFrame = 4.5;  // log-likelihood ratio: no frame verifies alone
constexpr double kCarried = 0.01;     // share of the jumps of a mode in which the robot was carried, not slipping
constexpr double kClearTurn = 5;      // standard deviations of a compass

/// Logarithm of the mean likelihood of the draws.
double logEvidence(const std::vector<Reading>& readings, const LandmarkTable& map, double max_range,
                   const ParticleSet& draws)
{
  const LandmarkClutter clutter;
  std::vector<float> log_likelihood(draws.size(), 0.0F);
  for (Reading reading : readings)
  {
    reading.model.max_range = reading.model.max_range.value_or(max_range);
    ReadingScorer(reading, map, clutter, draws.origin).addTo(draws.poses(), log_likelihood);
  }
  double sum = kLogZero;
  for (const float one : log_likelihood) sum = logSum(sum, double{one});
  return sum - std::log(static_cast<double>(draws.size()));
}

double logDensity(const GaussianPose& gaussian, const Pose2& pose)
{
  const double log_determinant = std::log(std::max(gaussian.covariance.determinant(), 1e-30));
  return -0.5 * (mahalanobis2(gaussian.mean, pose, gaussian.covariance) + log_determinant + 3 * std::log(kTwoPi));
}
}  // namespace

SymmetricRivals::SymmetricRivals(const LandmarkTable& map, double most) : most_(most), missed_(map.size())
{
  const auto [low, high] = map.boundingBox();
  const Vector2d extent = (high - low).cwiseMax(1.0);
  log_density_anywhere_ = -std::log(extent.prod() * kTwoPi);
  for (MapSymmetry& symmetry : mapSymmetries(map))
    rivals_.push_back({std::move(symmetry), MissedLandmarks(map.size())});
}

void SymmetricRivals::add(Rival& rival, double log_ratio) const
{
  rival.log_odds = std::clamp(rival.log_odds + log_ratio, -most_, most_);
}

void SymmetricRivals::start(const ParticleSet& particles, const PoseRegion& region)
{
  forgetMissed();
  for (Rival& rival : rivals_)
  {
    double possible = 0;
    for (std::size_t i = 0; i < particles.size(); ++i)
      if (region.contains(compose(rival.symmetry.motion, particles.pose(i))))
        possible += std::exp(double{particles.log_weight[i]});
    rival.log_odds = std::clamp(-std::log(possible), 0.0, most_);
  }
}

void SymmetricRivals::accept()
{
  for (Rival& rival : rivals_) rival.log_odds = most_;
}

void SymmetricRivals::rememberVerified()
{
  for (Rival& rival : rivals_) rival.log_odds_of_verified = rival.log_odds;
}

void SymmetricRivals::changeMode(const GaussianPose& before, const Pose2& now)
{
  forgetMissed();
  GaussianPose slipped = before;
  slipped.covariance.diagonal() += kSlipStd.cwiseAbs2();
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
    rival.log_odds = std::clamp(here - there, -most_, most_);
  }
}

void SymmetricRivals::useHeading(double std_heading)
{
  for (Rival& rival : rivals_)
    if (std::abs(wrap(rival.symmetry.motion.phi)) > kClearTurn * std_heading) rival.log_odds = most_;
}

void SymmetricRivals::update(const std::vector<Reading>& independent, const LandmarkTable& map,
                             const ParticleSet& particles)
{
  if (rivals_.empty() || independent.empty() || particles.empty()) return;
  const ParticleSet draws = select(particles, spacedDraws(particles, kDraws));
  const double max_range = defaultMaxRange(map);
  const double own = logEvidence(independent, map, max_range, draws);
  for (Rival& rival : rivals_)
    add(rival, std::clamp(own - logEvidence(independent, rival.symmetry.image, max_range, draws), -kMostOfFrame,
                          kMostOfFrame));
}

void SymmetricRivals::countMissed(const Reading& reading, const LandmarkTable& map, const ParticleSet& particles)
{
  if (rivals_.empty()) return;
  const double own = missed_.count(reading, map, particles);
  for (Rival& rival : rivals_) add(rival, own - rival.missed.count(reading, rival.symmetry.image, particles));
}

void SymmetricRivals::forgetMissed()
{
  missed_.clear();
  for (Rival& rival : rivals_) rival.missed.clear();
}

const SymmetricRivals::Rival* SymmetricRivals::strongestRival() const
{
  const auto least = std::min_element(rivals_.begin(), rivals_.end(),
                                      [](const Rival& a, const Rival& b) { return a.log_odds < b.log_odds; });
  return least == rivals_.end() ? nullptr : &*least;
}

double SymmetricRivals::logOdds() const
{
  const Rival* rival = strongestRival();
  return rival ? rival->log_odds : most_;
}

std::optional<Pose2> SymmetricRivals::strongest() const
{
  const Rival* rival = strongestRival();
  return rival ? std::optional(rival->symmetry.motion) : std::nullopt;
}
}  // namespace mrpt_ext
