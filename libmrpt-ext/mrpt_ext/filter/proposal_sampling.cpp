#include "mrpt_ext/filter/proposal_sampling.h"

#include <cmath>

#include "mrpt_ext/filter/particles/particle_bias.h"
#include "mrpt_ext/filter/particles/particle_order.h"
#include "mrpt_ext/geometry/work_counter.h"
#include "mrpt_ext/hypotheses/proposal.h"

namespace mrpt_ext
{
namespace
{
constexpr double kProposalInflation = 2.0;                    // a proposal is wider than the posterior it proposes for
const Vector3d kMinSeedingStd{0.002, 0.002, degToRad(0.02)};  // of a proposal
constexpr double kMinProposalWeight = 1e-4;
constexpr std::size_t kMaxModes = 500;
constexpr std::size_t kCostOfSeed = 200;  // in operations (work_counter.h), beside its density
}  // namespace

ProposalDistribution proposalAround(const HypothesisSet& hypotheses, const PoseRegion& region, double uniform_share)
{
  return {withWideCopies(hypotheses, kMinSeedStd), region, uniform_share, kProposalInflation, kMinSeedingStd};
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

ParticleSet sampleSeeds(const ProposalDistribution& proposal, const PoseRegion& region, std::size_t count,
                        RandomStream& random, const ParticleSet& like)
{
  ParticleSet particles = like.emptyLikeThis();
  particles.reserve(count);
  WorkCounter::add(kCostOfSeed * count);
  while (particles.size() < count)
  {
    const Pose2 pose = proposal.sample(random);
    const double prior = region.density(pose);
    // A seed outside the region has no prior weight; another draw keeps the count, the weights stay proportional.
    if (prior > 0) particles.add(pose, std::log(prior));
  }
  drawBiases(particles, 0, random);
  orderByPlace(particles);
  const std::vector<float> proposed = proposal.densities(particles.poses());
  for (std::size_t i = 0; i < count; ++i) particles.log_weight[i] -= std::log(proposed[i]);
  return particles;
}

HypothesisSet hypothesesFrom(const ModeSet& modes)
{
  HypothesisSet hypotheses;
  for (const Mode& mode : modes.modes)
  {
    if (mode.weight < kMinProposalWeight || hypotheses.size() == kMaxModes) break;
    hypotheses.push_back(
        {.pose = mode.pose, .log_score = std::log(mode.weight), .weight = mode.weight, .source = "particles"});
  }
  return hypotheses;
}
}  // namespace mrpt_ext
