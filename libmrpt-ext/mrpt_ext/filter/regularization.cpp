#include "mrpt_ext/filter/regularization.h"

#include <Eigen/Cholesky>

#include "mrpt_ext/filter/joint_regularization.h"
#include "mrpt_ext/filter/particles/particle_blocks.h"
#include "mrpt_ext/filter/regularization_kernel.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinRegularizedWeight = 0.01;  // lighter modes are not worth it

/// Modes to be regularized: wider ones have enough distinct poses, and a singular covariance has no spread to preserve.
std::vector<Mode> compactModes(const ModeSet& modes)
{
  std::vector<Mode> compact;
  for (const Mode& mode : modes.modes)
    if (mode.weight >= kMinRegularizedWeight && isCompact(mode) &&
        Eigen::LLT<Matrix3d>(mode.pose.covariance).info() == Eigen::Success)
      compact.push_back(mode);
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
