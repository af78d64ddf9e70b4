#pragma once

#include "mrpt_ext/filter/particles/particle_set.h"

namespace mrpt_ext
{
/// Options of the KLD sample size, with MRPT's names and meaning ([KLD_options]).
struct KldOptions
{
  double bin_xy = 0.2;              ///< KLD_binSize_XY [m]
  double bin_phi = degToRad(10.0);  ///< KLD_binSize_PHI_deg, kept in [rad]
  double delta = 0.01;              ///< KLD_delta: probability of exceeding epsilon
  double epsilon = 0.02;            ///< KLD_epsilon: allowed Kullback-Leibler distance
  std::size_t min_size = 250;       ///< KLD_minSampleSize
  std::size_t max_size = 100000;    ///< KLD_maxSampleSize
};

/// Sample size for a posterior that occupies `bins` bins (Fox 2003, "Adapting the sample size in particle filters
/// through KLD-sampling", eq. 7), without the limits.
[[nodiscard]] double kldSampleSize(std::size_t bins, double epsilon, double delta);

/// Number of bins that the particles occupy. Heading bins close at +-pi (MRPT's own do not).
[[nodiscard]] std::size_t occupiedBins(const ParticleSet& particles, const KldOptions& options);
}  // namespace mrpt_ext
