#include "mrpt_ext/filter/gaussian_proposal.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kFromPrior = 0.1;
constexpr double kWider = 1.2;  // standard deviations
}  // namespace

ParticleSet drawFromKalmanProposal(const ParticleSet& like, const KalmanState& prior, const KalmanState& posterior,
                                   std::size_t count, RandomStream& random)
{
  KalmanState wide = posterior;
  wide.covariance *= square(kWider);
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
      const double mixture = top + std::log(kFromPrior * std::exp(a - top) + (1 - kFromPrior) * std::exp(b - top));
      addParticle(particles, point, a - mixture - std::log(static_cast<double>(count)));
    }
  };
  const auto from_prior = static_cast<std::size_t>(kFromPrior * static_cast<double>(count));
  draw(prior.mean, of_prior, from_prior);
  draw(posterior.mean, of_posterior, count - from_prior);
  return particles;
}
}  // namespace mrpt_ext
