#include "mrpt_ext/filter/mode_mixture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mrpt_ext/filter/kalman/distinct_hypotheses.h"
#include "mrpt_ext/geometry/log_probability.h"
#include "mrpt_ext/geometry/mahalanobis.h"
#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
namespace
{
constexpr int kNoComponent = -1;
constexpr std::size_t kCostOfGate = 10, kCostOfShare = 20;  // of a particle, in operations (work_counter.h)
constexpr double kComponentGate = 5;      // standard deviations that the particles of a component are within
constexpr double kSameModeGate = 3;       // likewise for the mean of a mode
constexpr double kDuplicate = 1;          // likewise for another component
constexpr double kMinModeWeight = 0.005;  // of a mode that gets a component
constexpr std::size_t kMaxComponents = 30;
constexpr double kMaxUnsupported = 60;     // [s] without particles
constexpr double kMinLogWeight = -25;      // of a mode without particles
constexpr double kDetachedLogWeight = -7;  // that it starts with at most
constexpr double kRespawnWeight = 0.05;
// Residuals of the log weight within kSlack + kSigmas standard deviations are chance: many, because the sampling error
// of one frame influences the next ones. And the share that is remembered in the next frame.
constexpr double kSigmas = 6, kSlack = 1, kMemory = 0.98;

/// Weighted particles of one component, weights relative to the heaviest of all.
struct ParticleMass
{
  double sum = 0, sum2 = 0;
  void add(double weight)
  {
    sum += weight;
    sum2 += weight * weight;
  }
  [[nodiscard]] double logSum() const { return std::log(sum); }
  /// Relative variance of the sum: one over the effective number of particles.
  [[nodiscard]] double variance() const { return sum2 / (sum * sum); }
};
}  // namespace

double MixtureComponent::correctWeight(double residual, double variance)
{
  weight_residual = kMemory * weight_residual + residual;
  residual_variance = kMemory * kMemory * residual_variance + variance;
  if (std::abs(weight_residual) <= kSlack + kSigmas * std::sqrt(residual_variance)) return 0;
  const double correction = weight_residual;
  weight_residual = residual_variance = 0;
  return correction;
}

void ModeMixture::predictAndUpdate(const ParticleSet& predicted, const Frame& frame, const LandmarkTable& map)
{
  if (components_.empty()) return;
  for (MixtureComponent& component : components_)
  {
    component.state = predict(component.state, biases_, motion_, frame.motion);
    if (!component.has_particles) component.unsupported_for += frame.motion.duration;
  }
  assignParticles(predicted);
  const std::optional<Frame> affordable = affordableToUpdate(frame, map, components_.size());
  for (MixtureComponent& component : components_)
  {
    KalmanUpdate update = updateIterated(component.state, affordable ? *affordable : frame, map, biases_);
    component.state = std::move(update.state);
    component.log_evidence = update.log_evidence;
  }
}

void ModeMixture::assignParticles(const ParticleSet& predicted)
{
  std::vector<PoseGate> gates;
  for (const MixtureComponent& component : components_) gates.emplace_back(component.state, kComponentGate);
  component_of_.assign(predicted.size(), kNoComponent);
  prior_mass_.assign(components_.size(), 0.0);
  WorkCounter::add((kCostOfGate * components_.size() + kCostOfShare) * predicted.size());
  for (std::size_t i = 0; i < predicted.size(); ++i)
  {
    double nearest = square(kComponentGate);
    for (std::size_t k = 0; k < components_.size(); ++k)
    {
      if (!components_[k].has_particles) continue;
      const double distance2 = gates[k].distance2(predicted, i);
      if (!(distance2 < nearest)) continue;
      nearest = distance2;
      component_of_[i] = static_cast<int>(k);
    }
    if (component_of_[i] == kNoComponent) continue;
    prior_mass_[static_cast<std::size_t>(component_of_[i])] += std::exp(double{predicted.log_weight[i]});
  }
}

void ModeMixture::reweight(ParticleSet& particles)
{
  if (components_.empty() || component_of_.size() != particles.size()) return;
  const double top = double{*std::max_element(particles.log_weight.begin(), particles.log_weight.end())};
  std::vector<ParticleMass> masses(components_.size());
  WorkCounter::add(kCostOfShare * particles.size());
  double sum = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const double w = std::exp(double{particles.log_weight[i]} - top);
    sum += w;
    if (component_of_[i] != kNoComponent) masses[static_cast<std::size_t>(component_of_[i])].add(w);
  }

  // Log weights by the Kalman filters, and by the particles; the difference of the sums is common to all components.
  const auto is_supported = [&](std::size_t k) { return prior_mass_[k] > 0 && masses[k].sum > 0; };
  std::vector<double> log_weight(components_.size());
  double log_sum = kLogZero, log_particle_sum = kLogZero;
  for (std::size_t k = 0; k < components_.size(); ++k)
  {
    if (!is_supported(k)) continue;
    log_weight[k] = std::log(prior_mass_[k]) + components_[k].log_evidence;
    log_sum = logSum(log_sum, log_weight[k]);
    log_particle_sum = logSum(log_particle_sum, masses[k].logSum());
  }
  const double common = std::isinf(log_sum) ? -top : log_particle_sum - log_sum;
  double total = kLogZero;
  for (std::size_t k = 0; k < components_.size(); ++k)
  {
    if (!is_supported(k)) continue;
    log_weight[k] += components_[k].correctWeight(masses[k].logSum() - (log_weight[k] + common), masses[k].variance());
    total = logSum(total, log_weight[k]);
  }
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    if (component_of_[i] == kNoComponent) continue;
    const auto k = static_cast<std::size_t>(component_of_[i]);
    if (is_supported(k))
      particles.log_weight[i] += static_cast<float>(log_weight[k] + log_particle_sum - total - masses[k].logSum());
  }
  for (std::size_t k = 0; k < components_.size(); ++k)
  {
    MixtureComponent& component = components_[k];
    if (is_supported(k))
      component.log_weight = log_weight[k] + log_particle_sum - total - std::log(sum);
    else
      component.log_weight += component.log_evidence + common - std::log(sum);
  }
}

bool ModeMixture::respawn(ParticleSet& particles, std::size_t count, RandomStream& random)
{
  bool any = false;
  for (MixtureComponent& component : components_)
  {
    if (component.has_particles || component.log_weight < std::log(kRespawnWeight)) continue;
    const GaussianDensity density(component.state);
    const Eigen::MatrixXd normals = exactNormals(component.state.mean.size(), count, random);
    const double log_w = component.log_weight - std::log(static_cast<double>(count));
    for (Eigen::Index i = 0; i < normals.cols(); ++i)
    {
      const KalmanVector step = density.factor() * normals.col(i);
      addParticle(particles, moved(component.state.mean, step), log_w);
    }
    component.has_particles = any = true;
    component.unsupported_for = component.weight_residual = component.residual_variance = 0;
  }
  return any;
}

void ModeMixture::associate(const ModeSet& modes, const ParticleSet& particles)
{
  const auto compact = std::count_if(modes.modes.begin(), modes.modes.end(),
                                     [](const Mode& mode) { return mode.weight > kMinModeWeight && isCompact(mode); });
  if (components_.empty() && compact < 2) return;
  std::vector<bool> associated(components_.size(), false);
  for (std::size_t m = 0; m < modes.modes.size(); ++m)
  {
    const Mode& mode = modes.modes[m];
    if (mode.weight < kMinModeWeight) break;
    const auto known = std::find_if(components_.begin(), components_.end(),
                                    [&](const MixtureComponent& component)
                                    { return agree(component.state.gaussianPose(), mode.pose, kSameModeGate); });
    if (known == components_.end())
    {
      if (isCompact(mode)) add(modes, m, particles);
      continue;
    }
    const auto k = static_cast<std::size_t>(known - components_.begin());
    if (k < associated.size()) associated[k] = true;
    if (!known->has_particles) *known = {.state = known->state};  // found again by other means
  }
  for (std::size_t k = 0; k < associated.size(); ++k)
    if (!associated[k] && components_[k].has_particles) detach(components_[k]);
  prune();
}

void ModeMixture::retain(const Mode& mode, const ParticleSet& particles)
{
  if (!components_.empty() || !isCompact(mode)) return;
  const PoseGate gate(startingState(mode.pose, biases_), kComponentGate);
  if (const auto state = momentsOf(particles, [&](std::size_t i) { return gate.contains(particles, i); }))
    components_.push_back({.state = *state});
}

void ModeMixture::add(const ModeSet& modes, std::size_t mode, const ParticleSet& particles)
{
  if (components_.size() >= kMaxComponents) return;
  const auto state = momentsOf(particles, [&](std::size_t i) { return modes.mode_of[i] == static_cast<int>(mode); });
  if (state) components_.push_back({.state = *state, .log_weight = std::log(modes.modes[mode].weight)});
}

void ModeMixture::detach(MixtureComponent& component)
{
  component.has_particles = false;
  component.log_weight = std::min(component.log_weight, kDetachedLogWeight);
}

void ModeMixture::prune()
{
  std::erase_if(components_,
                [](const MixtureComponent& component)
                {
                  return !component.has_particles &&
                         (component.unsupported_for > kMaxUnsupported || component.log_weight < kMinLogWeight);
                });
  keepDistinct(
      components_,
      [](const MixtureComponent& a, const MixtureComponent& b)
      { return agree(a.state.gaussianPose(), b.state.gaussianPose(), kDuplicate); },
      [](MixtureComponent&, const MixtureComponent&) {});
  if (components_.size() == 1 && components_.front().has_particles) components_.clear();
}

std::size_t countCompactModes(const ModeSet& modes)
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
