#include "mrpt_ext/filter/regularization.h"

#include <Eigen/Cholesky>

#include "mrpt_ext/filter/joint_regularization.h"
#include "mrpt_ext/filter/particles/particle_blocks.h"
#include "mrpt_ext/filter/regularization_kernel.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinWeight = 0.01;  // lighter modes are not worth it

/// Modes narrow enough to be smoothed, and not all in one place: there is no spread to keep.
std::vector<Mode> compactModes(const ModeSet& modes, const Regularization& options)
{
  std::vector<Mode> compact;
  for (const Mode& mode : modes.modes)
  {
    const Matrix3d& C = mode.pose.covariance;
    const bool narrow = C(0, 0) + C(1, 1) < square(options.max_std_xy) && C(2, 2) < square(options.max_std_phi);
    if (mode.weight >= kMinWeight && narrow && Eigen::LLT<Matrix3d>(C).info() == Eigen::Success)
      compact.push_back(mode);
  }
  return compact;
}

}  // namespace

void regularizeModes(ParticleSet& particles, const ModeSet& modes, const Regularization& options, RandomStream& random,
                     unsigned threads)
{
  const std::vector<Mode> narrow = compactModes(modes, options);
  const std::uint64_t seed = random.nextBits();
  if (narrow.empty()) return;
  if (!particles.bias.empty()) return smoothJointly(particles, narrow, options.bandwidth, random);
  std::vector<SmoothedMode> compact;
  for (const Mode& mode : narrow)
    compact.push_back(
        smoothedMode(mode.pose, particles.origin, mode.pose.covariance.llt().matrixL(), options.bandwidth));
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t count)
               {
                 SimdRandom lanes(seed, first / kParticleBlock);
                 smoothBlock(particles, compact, first, count, lanes);
               });
}
}  // namespace mrpt_ext
