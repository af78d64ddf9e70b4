#include "mrpt_ext/filter/seeding.h"

#include <cmath>

#include "mrpt_ext/filter/particle_bias.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinWeight = 1e-4;
constexpr std::size_t kMaxModes = 500;
}  // namespace

ParticleSet sampleSeeds(const SeedMixture& mixture, const PoseRegion& region, std::size_t count, RandomStream& random,
                        const ParticleSet& like)
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

HypothesisSet hypothesesOf(const ModeSet& modes)
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
