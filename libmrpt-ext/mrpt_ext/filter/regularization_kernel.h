#pragma once

#include <Eigen/LU>
#include <span>

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/filter/particles/simd_random.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// A compact mode in single precision: mean from the origin of the particles, W with W C W^T = 1 for its covariance C
/// (lower triangle), and the kernel: x' = mean + keep (x - mean) + L u.
struct RegularizedMode
{
  float x, y, phi;
  float wxx, wyx, wyy, wpx, wpy, wpp;
  float keep;
  float lxx, lyx, lyy, lpx, lpy, lpp;
};

/// `factor`: lower Cholesky factor of the covariance.
[[nodiscard]] RegularizedMode regularizedMode(const GaussianPose& pose, const Vector2d& origin, const Matrix3d& factor,
                                              double bandwidth);

/// Moves each of `count` particles from `first` on with the mode that is nearest by Mahalanobis distance, if it is
/// within 4 standard deviations: a wide mode must not attract the particles of a narrow one inside it.
void regularizeBlock(ParticleSet& particles, std::span<const RegularizedMode> modes, std::size_t first,
                     std::size_t count, SimdRandom& random);
}  // namespace mrpt_ext
