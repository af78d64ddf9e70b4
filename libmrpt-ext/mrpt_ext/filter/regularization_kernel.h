#pragma once

#include <Eigen/LU>
#include <span>

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/filter/particles/simd_random.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// A compact mode in single precision: mean from the origin of the particles, W with W C W^T = 1 for its covariance C
/// (lower triangle), and how its particles are moved: x' = mean + keep (x - mean) + L u.
struct SmoothedMode
{
  float x, y, phi;
  float wxx, wyx, wyy, wpx, wpy, wpp;
  float keep;
  float lxx, lyx, lyy, lpx, lpy, lpp;
};

/// `factor`: lower Cholesky factor of the covariance.
[[nodiscard]] SmoothedMode smoothedMode(const GaussianPose& pose, const Vector2d& origin, const Matrix3d& factor,
                                        double bandwidth);

/// Moves each of `count` particles from `first` on with the mode that it is nearest to by Mahalanobis distance, if it
/// lies within 4 standard deviations of it: a wide mode must not draw in a sharp one within its reach.
void smoothBlock(ParticleSet& particles, std::span<const SmoothedMode> modes, std::size_t first, std::size_t count,
                 SimdRandom& random);
}  // namespace mrpt_ext
