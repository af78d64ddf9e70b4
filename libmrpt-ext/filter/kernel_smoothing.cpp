#include "mrpt_ext/filter/kernel_smoothing.h"

#include <Eigen/Cholesky>

#include "mrpt_ext/filter/particle_blocks.h"
#include "mrpt_ext/filter/smoothing_kernel.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMinWeight = 0.01;  // lighter modes are not worth it

std::vector<SmoothedMode> compactModes(const ModeSet& modes, const KernelSmoothing& options, const Vector2d& origin)
{
  std::vector<SmoothedMode> compact;
  for (const Mode& mode : modes.modes)
  {
    const Matrix3d& C = mode.pose.covariance;
    const bool narrow = C(0, 0) + C(1, 1) < square(options.max_std_xy) && C(2, 2) < square(options.max_std_phi);
    if (mode.weight < kMinWeight || !narrow) continue;
    const Eigen::LLT<Matrix3d> llt(C);
    if (llt.info() != Eigen::Success) continue;  // all particles in one place: there is no spread to keep
    compact.push_back(smoothedMode(mode.pose, origin, llt.matrixL(), options.bandwidth));
  }
  return compact;
}

}  // namespace

void smoothModes(ParticleSet& particles, const ModeSet& modes, const KernelSmoothing& options, RandomStream& random,
                 unsigned threads)
{
  const std::vector<SmoothedMode> compact = compactModes(modes, options, particles.origin);
  const std::uint64_t seed = random.nextBits();
  if (compact.empty()) return;
  forEachBlock(particles.size(), threads,
               [&](std::size_t first, std::size_t count)
               {
                 RandomLanes lanes(seed, first / kParticleBlock);
                 smoothBlock(particles, compact, first, count, lanes);
               });
}
}  // namespace mrpt_ext
