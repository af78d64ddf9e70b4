#include "mrpt_ext/filter/gaussian_proposal.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/filter/kalman/kalman_update.h"

namespace mrpt_ext
{
namespace
{
constexpr double kPriorShare = 0.1;
constexpr double kInflation = 1.2;  // of the standard deviations
}  // namespace

ParticleSet drawFromKalmanProposal(const ParticleSet& like, const KalmanState& prior, const KalmanState& posterior,
                                   std::size_t count, double inflation, RandomStream& random)
{
  KalmanState wide = posterior;
  wide.covariance *= square(inflation);
  const GaussianDensity of_prior(prior), of_posterior(wide);
  ParticleSet particles = like.emptyLikeThis();
  particles.reserve(count);
  const auto draw = [&](const KalmanVector& mean, const GaussianDensity& from, std::size_t number)
  {
    const Eigen::MatrixXd normals = exactNormals(mean.size(), number, random);
    for (Eigen::Index i = 0; i < normals.cols(); ++i)
    {
      const KalmanVector step = from.factor() * normals.col(i);
      const KalmanVector point = moved(mean, step);
      const double a = of_prior.log(point), b = of_posterior.log(point);
      // Against the mixture: log(share e^a + (1 - share) e^b) without overflow.
      const double top = std::max(a, b);
      const double mixture = top + std::log(kPriorShare * std::exp(a - top) + (1 - kPriorShare) * std::exp(b - top));
      addParticle(particles, point, a - mixture - std::log(static_cast<double>(count)));
    }
  };
  const auto from_prior = static_cast<std::size_t>(kPriorShare * static_cast<double>(count));
  draw(prior.mean, of_prior, from_prior);
  draw(posterior.mean, of_posterior, count - from_prior);
  return particles;
}

void proposeFromKalman(ParticleSet& particles, const KalmanState& prior, const Frame& frame, const LandmarkTable& map,
                       const KalmanProposalLimits& limits, const WeightParticles& weight, RandomStream& random)
{
  const auto effective = [&]
  { return normalizeWeights(particles).effective_ratio * static_cast<double>(particles.size()); };
  const double before = effective();
  if (before > static_cast<double>(limits.effective) ||
      before > limits.effective_ratio * static_cast<double>(particles.size()))
    return;
  const std::optional<Frame> affordable = affordableToUpdate(frame, map, 1);
  const KalmanUpdate update = updateIterated(prior, affordable ? *affordable : frame, map, particles.bias_states);
  if (update.degrees_of_freedom == 0) return;
  ParticleSet moved = std::move(particles);
  particles = drawFromKalmanProposal(moved, prior, update.state, moved.size(), kInflation, random);
  weight(frame, particles);
  if (effective() < before) particles = std::move(moved);
}
}  // namespace mrpt_ext
