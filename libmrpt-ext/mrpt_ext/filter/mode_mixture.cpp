#include "mrpt_ext/filter/mode_mixture.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace mrpt_ext
{
namespace
{
constexpr int kNobody = -1;
constexpr double kNothing = -std::numeric_limits<double>::infinity();
constexpr double kGate = 5;           // standard deviations of a companion within which a particle is its own
constexpr double kSamePlace = 3;      // likewise for the mean of a mode
constexpr double kMinWeight = 0.005;  // of a mode that gets a companion
constexpr std::size_t kMaxCompanions = 30;
constexpr double kMaxStdXy = 0.5, kMaxStdPhi = degToRad(20.0);  // wider modes are no places
constexpr double kForgottenAfter = 60;                          // [s] without particles
constexpr double kLeastLogWeight = -25;                         // of a place without particles
constexpr double kDroppedLogWeight = -7;                        // that it starts with
constexpr double kRevivedAt = 0.05;                             // weight
// How far companion and particles may differ, in standard deviations and log units: far, because the sampling errors of
// one frame are felt in the next ones; and how much of it is remembered in the next frame.
constexpr double kDoubt = 6, kSlack = 1, kRemembered = 0.98;

bool isCompact(const Mode& mode)
{
  const Matrix3d& C = mode.pose.covariance;
  return C(0, 0) + C(1, 1) < square(kMaxStdXy) && C(2, 2) < square(kMaxStdPhi);
}

/// Mahalanobis distance of two places, by the uncertainty of both.
double apart(const KalmanState& a, const GaussianPose& b)
{
  Vector3d d = a.mean.head<3>() - b.mean.vector();
  d.z() = wrap(d.z());
  const Matrix3d C = a.gaussianPose().covariance + b.covariance + 1e-9 * Matrix3d::Identity();
  return std::sqrt(std::max(0.0, d.dot(C.ldlt().solve(d))));
}

double logSum(double a, double b)
{
  const double top = std::max(a, b);
  return std::isinf(top) ? top : top + std::log(std::exp(a - top) + std::exp(b - top));
}

/// Scored particles of one companion, weights relative to the heaviest of all.
struct ScoredMass
{
  double sum = 0, sum2 = 0;
  [[nodiscard]] double logSum() const { return std::log(sum); }
  /// Relative variance of the sum: one over the effective number of particles.
  [[nodiscard]] double variance() const { return sum2 / (sum * sum); }
};
}  // namespace

double MixtureComponent::settle(double difference, double variance)
{
  owed = kRemembered * owed + difference;
  owed_variance = kRemembered * kRemembered * owed_variance + variance;
  if (std::abs(owed) <= kSlack + kDoubt * std::sqrt(owed_variance)) return 0;
  const double due = owed;
  owed = owed_variance = 0;
  return due;
}

void ModeMixture::predictAndUpdate(const ParticleSet& moved_particles, const Frame& frame, const LandmarkTable& map)
{
  if (companions_.empty()) return;
  std::vector<PoseGate> gates;
  for (MixtureComponent& companion : companions_)
  {
    companion.state = predict(companion.state, biases_, motion_, frame.motion);
    gates.emplace_back(companion.state, kGate);
    if (!companion.has_particles) companion.alone_for += frame.motion.duration;
  }
  companion_of_.assign(moved_particles.size(), kNobody);
  prior_mass_.assign(companions_.size(), 0.0);
  for (std::size_t i = 0; i < moved_particles.size(); ++i)
  {
    double nearest = square(kGate);
    for (std::size_t k = 0; k < companions_.size(); ++k)
    {
      if (!companions_[k].has_particles) continue;
      const double distance2 = gates[k].distance2(moved_particles, i);
      if (!(distance2 < nearest)) continue;
      nearest = distance2;
      companion_of_[i] = static_cast<int>(k);
    }
    if (companion_of_[i] == kNobody) continue;
    prior_mass_[static_cast<std::size_t>(companion_of_[i])] += std::exp(double{moved_particles.log_weight[i]});
  }
  for (MixtureComponent& companion : companions_)
  {
    KalmanUpdate update = updateIterated(companion.state, frame, map, biases_);
    companion.state = std::move(update.state);
    companion.log_evidence = update.log_evidence;
  }
}

void ModeMixture::reweight(ParticleSet& particles)
{
  if (companions_.empty() || companion_of_.size() != particles.size()) return;
  const double top = double{*std::max_element(particles.log_weight.begin(), particles.log_weight.end())};
  std::vector<ScoredMass> scored(companions_.size());
  double all = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const double w = std::exp(double{particles.log_weight[i]} - top);
    all += w;
    if (companion_of_[i] == kNobody) continue;
    ScoredMass& mass = scored[static_cast<std::size_t>(companion_of_[i])];
    mass.sum += w;
    mass.sum2 += w * w;
  }

  // What companions and particles say, and what is owed by one to the other: that of all of them together is common.
  const auto counts = [&](std::size_t k) { return prior_mass_[k] > 0 && scored[k].sum > 0; };
  std::vector<double> said(companions_.size());
  double log_said = kNothing, log_scored = kNothing;
  for (std::size_t k = 0; k < companions_.size(); ++k)
  {
    if (!counts(k)) continue;
    said[k] = std::log(prior_mass_[k]) + companions_[k].log_evidence;
    log_said = logSum(log_said, said[k]);
    log_scored = logSum(log_scored, scored[k].logSum());
  }
  const double common = std::isinf(log_said) ? -top : log_scored - log_said;
  double total = kNothing;
  for (std::size_t k = 0; k < companions_.size(); ++k)
  {
    if (!counts(k)) continue;
    said[k] += companions_[k].settle(scored[k].logSum() - (said[k] + common), scored[k].variance());
    total = logSum(total, said[k]);
  }
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    if (companion_of_[i] == kNobody) continue;
    const auto k = static_cast<std::size_t>(companion_of_[i]);
    if (counts(k)) particles.log_weight[i] += static_cast<float>(said[k] + log_scored - total - scored[k].logSum());
  }
  for (std::size_t k = 0; k < companions_.size(); ++k)
  {
    MixtureComponent& companion = companions_[k];
    if (counts(k))
      companion.log_weight = said[k] + log_scored - total - std::log(all);
    else
      companion.log_weight += companion.log_evidence + common - std::log(all);
  }
}

bool ModeMixture::revive(ParticleSet& particles, std::size_t count, RandomStream& random)
{
  bool any = false;
  for (MixtureComponent& companion : companions_)
  {
    if (companion.has_particles || companion.log_weight < std::log(kRevivedAt)) continue;
    const GaussianDensity density(companion.state);
    const Eigen::MatrixXd normals = exactNormals(companion.state.mean.size(), count, random);
    const double log_w = companion.log_weight - std::log(static_cast<double>(count));
    for (Eigen::Index i = 0; i < normals.cols(); ++i)
    {
      const KalmanVector step = density.factor() * normals.col(i);
      addParticle(particles, moved(companion.state.mean, step), log_w);
    }
    companion.has_particles = any = true;
    companion.alone_for = companion.owed = companion.owed_variance = 0;
  }
  return any;
}

void ModeMixture::follow(const ModeSet& modes, const ParticleSet& particles)
{
  const auto places = std::count_if(modes.modes.begin(), modes.modes.end(),
                                    [](const Mode& mode) { return mode.weight > kMinWeight && isCompact(mode); });
  if (companions_.empty() && places < 2) return;
  std::vector<bool> followed(companions_.size(), false);
  for (std::size_t m = 0; m < modes.modes.size(); ++m)
  {
    const Mode& mode = modes.modes[m];
    if (mode.weight < kMinWeight) break;
    const auto known =
        std::find_if(companions_.begin(), companions_.end(),
                     [&](const MixtureComponent& companion) { return apart(companion.state, mode.pose) < kSamePlace; });
    if (known == companions_.end())
    {
      if (isCompact(mode)) seat(modes, m, particles);
      continue;
    }
    const auto k = static_cast<std::size_t>(known - companions_.begin());
    if (k < followed.size()) followed[k] = true;
    if (!known->has_particles) *known = {.state = known->state};  // found again by other means
  }
  for (std::size_t k = 0; k < followed.size(); ++k)
    if (!followed[k] && companions_[k].has_particles) retire(companions_[k]);
  forget();
}

void ModeMixture::watch(const Mode& mode, const ParticleSet& particles)
{
  if (!companions_.empty() || !isCompact(mode)) return;
  const PoseGate gate(startingState(mode.pose, biases_), kGate);
  if (const auto state = momentsOf(particles, [&](std::size_t i) { return gate.contains(particles, i); }))
    companions_.push_back({.state = *state});
}

void ModeMixture::seat(const ModeSet& modes, std::size_t mode, const ParticleSet& particles)
{
  if (companions_.size() >= kMaxCompanions) return;
  const auto state = momentsOf(particles, [&](std::size_t i) { return modes.mode_of[i] == static_cast<int>(mode); });
  if (state) companions_.push_back({.state = *state, .log_weight = std::log(modes.modes[mode].weight)});
}

void ModeMixture::retire(MixtureComponent& companion)
{
  companion.has_particles = false;
  companion.log_weight = std::min(companion.log_weight, kDroppedLogWeight);
}

void ModeMixture::forget()
{
  std::erase_if(companions_,
                [](const MixtureComponent& companion)
                {
                  return !companion.has_particles &&
                         (companion.alone_for > kForgottenAfter || companion.log_weight < kLeastLogWeight);
                });
  std::vector<MixtureComponent> kept;
  for (MixtureComponent& companion : companions_)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const MixtureComponent& other)
                     { return apart(other.state, companion.state.gaussianPose()) < 1; }))
      kept.push_back(std::move(companion));
  companions_ = std::move(kept);
  if (companions_.size() == 1 && companions_.front().has_particles) companions_.clear();
}

std::size_t countPlaces(const ModeSet& modes)
{
  double weight = 0;
  for (std::size_t m = 0; m < modes.modes.size() && isCompact(modes.modes[m]); ++m)
  {
    weight += modes.modes[m].weight;
    if (weight > 0.99) return m + 1;
  }
  return 0;
}
}  // namespace mrpt_ext
