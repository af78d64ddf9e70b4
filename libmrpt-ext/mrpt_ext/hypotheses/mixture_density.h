#pragma once

#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/likelihood/pose_batch.h"

namespace mrpt_ext
{
/// One weighted Gaussian of a mixture in single precision, for the inner loop over many poses. Lengths [m] are relative
/// to the origin of the poses.
struct MixtureTerm
{
  float x = 0, y = 0, phi = 0;                                   ///< mean
  float xx = 0, xy = 0, xphi = 0, yy = 0, yphi = 0, phiphi = 0;  ///< quadratic form of the exponent to base 2
  float log2_peak = 0;                                           ///< of the density at the mean, times the weight
  float half_x = 0, half_y = 0;  ///< [m] of the box outside of which its density is nothing
  bool full_turns = false;       ///< so wide that samples a full turn away count (wrapped normal distribution)

  [[nodiscard]] bool reaches(float low_x, float high_x, float low_y, float high_y) const
  {
    return x + half_x >= low_x && x - half_x <= high_x && y + half_y >= low_y && y - half_y <= high_y;
  }
};

/// Adds the density of the term [1/(m^2 rad)] at each pose, to 1e-5 of its peak.
void addDensity(const MixtureTerm& term, std::span<const float> x, std::span<const float> y, std::span<const float> phi,
                std::span<float> density);
}  // namespace mrpt_ext
