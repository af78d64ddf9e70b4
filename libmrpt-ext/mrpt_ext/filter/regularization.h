#pragma once

#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
struct Regularization
{
  double bandwidth = 0.1;               ///< h: share of a mode's standard deviation that each particle is moved by
  double max_std_xy = 0.5;              ///< [m] wider modes have room enough and are left alone
  double max_std_phi = degToRad(20.0);  ///< [rad]
};

/// Keeps resampled copies apart. A robot at standstill has next to no motion noise, and particles that are only copied
/// soon are few places with many copies. Every particle of a compact mode is drawn a little towards the mode's mean and
/// then moved at random, x' = sqrt(1 - h^2) (x - mean) + mean + h L u with L L^T the mode's covariance: mean and
/// covariance stay what they were (Liu and West, "Combined parameter and state estimation in simulation-based
/// filtering", 2001).
/// Systematic errors are moved with the pose (joint_regularization.h). Without any, one number is drawn from `random`,
/// which seeds all blocks of particles; `threads` change nothing but the time.
void regularizeModes(ParticleSet& particles, const ModeSet& modes, const Regularization& options, RandomStream& random,
                     unsigned threads = 1);
}  // namespace mrpt_ext
