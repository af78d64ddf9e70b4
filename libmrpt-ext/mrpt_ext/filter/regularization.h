#pragma once

#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
struct Regularization
{
  double bandwidth = 0.1;  ///< h: standard deviation of the kernel relative to that of the mode
};

/// Regularizes resampled particles. A robot at standstill has next to no motion noise, and particles that are only
/// copied soon have few distinct poses. Every particle of a compact mode (0.5 m, 20 deg) is shrunk towards the mode's
/// mean and then perturbed, x' = sqrt(1 - h^2) (x - mean) + mean + h L u with L L^T the mode's covariance: mean and
/// covariance stay the same (Liu and West, "Combined parameter and state estimation in simulation-based filtering",
/// 2001). Systematic errors are moved with the pose (joint_regularization.h). Without any, one number is drawn from
/// `random`, which seeds all blocks of particles; `threads` change nothing but the time.
void regularizeModes(ParticleSet& particles, const ModeSet& modes, const Regularization& options, RandomStream& random,
                     unsigned threads = 1);
}  // namespace mrpt_ext
