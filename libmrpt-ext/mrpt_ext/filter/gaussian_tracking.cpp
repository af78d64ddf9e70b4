#include "mrpt_ext/filter/gaussian_tracking.h"

#include "mrpt_ext/filter/kalman/kalman_update.h"
#include "mrpt_ext/likelihood/scoring_work.h"

namespace mrpt_ext
{
namespace
{
constexpr double kTailFactor = 1.1;    // of the standard deviations: tails of the posterior must not be missed
constexpr double kConfirmation = 0.5;  // effective ratio
}  // namespace

ParticleSet drawGaussian(const ParticleSet& like, const KalmanState& state, std::size_t count, RandomStream& random)
{
  ParticleSet particles = like.emptyLikeThis();
  particles.reserve(count);
  const GaussianDensity density(state);
  const Eigen::MatrixXd normals = exactNormals(state.mean.size(), count, random);
  const double log_w = -std::log(static_cast<double>(count));
  for (Eigen::Index i = 0; i < normals.cols(); ++i)
    addParticle(particles, moved(state.mean, density.factor() * normals.col(i)), log_w);
  return particles;
}

GaussianUpdate updateGaussian(const KalmanState& prior, const Frame& frame, const LandmarkTable& map,
                              const ParticleSet& like, std::size_t count, RandomStream& random)
{
  const std::optional<Frame> affordable = affordableToUpdate(frame, map, 1);
  KalmanState posterior = updateIterated(prior, affordable ? *affordable : frame, map, like.bias_states).state;
  ParticleSet samples = drawFromKalmanProposal(like, prior, posterior, count, kTailFactor, random);
  return {prior, std::move(posterior), std::move(samples)};
}

bool isConfirmed(const GaussianUpdate& update, const Frame& frame, const WeightParticles& weight)
{
  if (detectionCount(frame) == 0) return true;  // a compass at most, which is Gaussian
  ParticleSet samples = update.samples;
  weight(frame, samples);
  return normalizeWeights(samples).effective_ratio >= kConfirmation;
}
}  // namespace mrpt_ext
