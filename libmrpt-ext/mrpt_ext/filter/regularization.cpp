#include "mrpt_ext/filter/regularization.h"

#include <Eigen/Cholesky>

#include "mrpt_ext/filter/joint_regularization.h"
#include "mrpt_ext/filter/particles/particle_blocks.h"
#include "mrpt_ext/filter/regularization_kernel.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinRegularizedWeight = 0.01;                  // lighter modes are not worth it
constexpr double kMaxStdXy = 0.5, kMaxStdPhi = degToRad(20.0);  // wider modes have enough distinct poses

/// Modes narrow enough to be regularized whose covariance is not singular: else there is no spread to preserve.
std::vector<Mode> compactModes(const ModeSet& modes)
{
  std::vector<Mode> compact;
  for (const Mode& mode : modes.modes)
  {
    const Matrix3d& C = mode.pose.covariance;
    const bool narrow = C(0, 0) + C(1, 1) < square(kMaxStdXy) && C(2, 2) < square(kMaxStdPhi);
    if (mode.weight >= kMinRegularizedWeight && narrow && Eigen::LLT<Matrix3d>(C).info() == Eigen::Success)
      compact.push_back(mode);
  }
  return compact;
}
}  // namespace

void regularizeModes(ParticleSet& particles, const ModeSet& modes, const Regularization& options, RandomStream& random,
                     unsigned threads)
{
  const std::vector<Mode> narrow = compactModes(modes);
  const std::uint64_t seed = random.nextBits();
  if (narrow.empty()) return;
  if (!particles.bias.empty()) return regularizeJointly(particles, narrow, options.bandwidth, random);
  std::vector<RegularizedMode> compact;
  for (const Mode& mode : narrow)
    compact.push_back(
        regularizedMode(mode.pose, particles.origin, mode.pose.covariance.llt().matrixL(), options.bandwidth));
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t count)
               {
                 SimdRandom block_random(seed, first / kParticleBlock);
                 regularizeBlock(particles, compact, first, count, block_random);
               });
}
}  // namespace mrpt_ext
