#include "mrpt_ext/filter/initialization.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/particles/particle_bias.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinWeight = 1e-4;
constexpr std::size_t kMaxModes = 500;
constexpr int kHalvings = 14;
constexpr double kLeastExponent = 1e-4;
}  // namespace

ParticleSet sampleSeeds(const ProposalDistribution& mixture, const PoseRegion& region, std::size_t count,
                        RandomStream& random, const ParticleSet& like)
{
  ParticleSet particles = like.emptyLikeThis();
  particles.reserve(count);
  while (particles.size() < count)
  {
    const Pose2 pose = mixture.sample(random);
    const double prior = region.density(pose);
    // A seed outside the region has no prior weight; another draw keeps the count, the weights stay proportional.
    if (prior > 0) particles.add(pose, std::log(prior / mixture.density(pose)));
  }
  drawBiases(particles, 0, random);
  return particles;
}

HypothesisSet withWideCopies(const HypothesisSet& hypotheses, const Vector3d& wide_std)
{
  HypothesisSet both = hypotheses;
  for (PoseHypothesis wide : hypotheses)
  {
    wide.pose.covariance.diagonal() += wide_std.cwiseAbs2();
    both.push_back(std::move(wide));
  }
  return both;
}

double annealingExponent(std::span<const float> log_prior, std::span<const float> log_weight, double effective)
{
  const auto effective_at = [&](double exponent)
  {
    const auto at = [&](std::size_t i)
    { return double{log_prior[i]} + exponent * (double{log_weight[i]} - double{log_prior[i]}); };
    double best = at(0), sum = 0, squares = 0;
    for (std::size_t i = 1; i < log_prior.size(); ++i) best = std::max(best, at(i));
    for (std::size_t i = 0; i < log_prior.size(); ++i)
    {
      const double w = std::exp(at(i) - best);
      sum += w;
      squares += w * w;
    }
    return sum * sum / squares;
  };
  if (log_prior.empty() || effective_at(1) >= effective) return 1;
  double low = 0, high = 1;
  for (int k = 0; k < kHalvings; ++k)
  {
    const double middle = (low + high) / 2;
    (effective_at(middle) >= effective ? low : high) = middle;
  }
  return std::max(low, kLeastExponent);
}

HypothesisSet hypothesesFrom(const ModeSet& modes)
{
  HypothesisSet hypotheses;
  for (const Mode& mode : modes.modes)
  {
    if (mode.weight < kMinWeight || hypotheses.size() == kMaxModes) break;
    hypotheses.push_back(
        {.pose = mode.pose, .log_score = std::log(mode.weight), .weight = mode.weight, .source = "particles"});
  }
  return hypotheses;
}
}  // namespace mrpt_ext
