#include "mrpt_ext/filter/hypothesis_injector.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/particle_moments.h"
#include "mrpt_ext/filter/particles/particle_bias.h"
#include "mrpt_ext/filter/particles/particle_order.h"
#include "mrpt_ext/filter/proposal_sampling.h"

namespace mrpt_ext
{
namespace
{
constexpr double kInjectedUniformShare = 0.3;
constexpr double kMaxOdds = 10;                             // of a trajectory
constexpr double kNearXy = 0.7, kNearPhi = degToRad(20.0);  // a trajectory estimates poses roughly

bool isNear(const Pose2& a, const Pose2& b)
{
  return (a.position() - b.position()).norm() < kNearXy && std::abs(wrap(a.phi - b.phi)) < kNearPhi;
}

/// Leaves `share` of the weight for others.
void scaleWeights(ParticleSet& particles, double share)
{
  for (float& log_w : particles.log_weight) log_w += static_cast<float>(std::log1p(-share));
}
}  // namespace

std::size_t HypothesisInjector::count() const
{
  return static_cast<std::size_t>(std::ceil(options_.injected_particle_share * static_cast<double>(particles_)));
}

HypothesisSet HypothesisInjector::withSlip(HypothesisSet modes) const
{
  if (!(options_.slip_share > 0)) return {};
  for (PoseHypothesis& mode : modes) mode.pose = afterSlip(mode.pose);
  return modes;
}

void HypothesisInjector::inject(ParticleSet& particles, HypothesisSet proposed, const HypothesisSet& slipped,
                                double prior, RandomStream& random) const
{
  proposed.insert(proposed.end(), slipped.begin(), slipped.end());
  const ProposalDistribution proposal = proposalAround(proposed, region_, kInjectedUniformShare);
  const ProposalDistribution slips(slipped, region_, 0, 1, Vector3d::Zero());
  const double slip_share = slipped.empty() ? 0 : options_.slip_share;
  scaleWeights(particles, prior);
  const std::size_t injected = count();
  ParticleSet added = particles.emptyLikeThis();
  for (std::size_t i = 0; i < injected; ++i)
  {
    const Pose2 pose = proposal.sample(random);
    const double uniform = region_.density(pose);
    if (!(uniform > 0)) continue;
    const double elsewhere = (1 - slip_share) * uniform + (slipped.empty() ? 0 : slip_share * slips.density(pose));
    added.add(pose, std::log(prior * elsewhere / (proposal.density(pose) * static_cast<double>(injected))));
  }
  drawBiases(added, 0, random);
  orderByPlace(added);
  for (std::size_t i = 0; i < added.size(); ++i) particles.addCopy(added, i, double{added.log_weight[i]});
}

void HypothesisInjector::injectTrajectory(ParticleSet& particles, const HypothesisSet& trajectory, double share,
                                          RandomStream& random) const
{
  double sum = 0;
  for (const PoseHypothesis& hypothesis : trajectory) sum += hypothesis.weight;
  if (!(sum > 0)) return;
  scaleWeights(particles, share);
  const std::size_t kept = particles.size();
  for (const PoseHypothesis& hypothesis : trajectory)
  {
    const double weight = share * hypothesis.weight / sum;
    if (weight < kMinInjectedWeight) continue;
    const Matrix3d factor = Eigen::LLT<Matrix3d>(hypothesis.pose.covariance).matrixL();
    const Eigen::MatrixXd normals = exactNormals(3, particles_, random);
    for (Eigen::Index i = 0; i < normals.cols(); ++i)
    {
      const Vector3d offset = factor * normals.col(i);
      const Pose2& mean = hypothesis.pose.mean;
      particles.add({mean.x + offset.x(), mean.y + offset.y(), wrap(mean.phi + offset.z())},
                    std::log(weight / static_cast<double>(particles_)));
    }
  }
  drawBiases(particles, kept, random);
}

double weightElsewhere(const HypothesisSet& trajectory, const Pose2& best)
{
  double sum = 0;
  for (const PoseHypothesis& hypothesis : trajectory)
    if (!isNear(best, hypothesis.pose.mean)) sum += hypothesis.weight;
  return sum;
}

double injectedShare(double elsewhere, double log_odds)
{
  const double odds_elsewhere = elsewhere < 1 ? std::min(elsewhere / (1 - elsewhere), kMaxOdds) : kMaxOdds;
  const double odds = odds_elsewhere * std::exp(-std::max(0.0, log_odds));
  return odds / (1 + odds);
}
}  // namespace mrpt_ext
