#pragma once

#include <vector>

#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// How finely the posterior is split into modes.
struct ModeOptions
{
  double cell_xy = 0.25;             ///< [m] two peaks closer than about two cells are one mode
  double cell_phi = degToRad(20.0);  ///< [rad]
};

/// One peak of the posterior.
struct Mode
{
  GaussianPose pose;  ///< weighted mean (heading: about the circular mean) and covariance of its particles
  double weight = 0;
};

/// True for a mode narrow enough to be taken for a Gaussian.
[[nodiscard]] bool isCompact(const Mode& mode);

struct ModeSet
{
  std::vector<Mode> modes;   ///< heaviest first
  std::vector<int> mode_of;  ///< per particle: position in `modes`
};

/// Splits normalised particles into modes: cells of a grid over (x, y, phi, wrapped) that are heavy enough and touch
/// form a core; every lighter cell climbs to its heaviest neighbour until it reaches a core or a peak of its own.
/// The result does not depend on `threads`. `buffer` is reused for `mode_of`.
[[nodiscard]] ModeSet findModes(const ParticleSet& particles, const ModeOptions& options, unsigned threads = 1,
                                std::vector<int> buffer = {});
}  // namespace mrpt_ext
