#pragma once

#include <functional>
#include <span>

#include "mrpt_ext/filter/gaussian_proposal.h"
#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/filter/particle_filter_options.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// Steps of each particle in one move at most.
inline constexpr int kMostSweeps = 40;

/// Sets the log weights to the logarithm of the posterior density at the particles, up to a constant; minus infinity
/// where it is zero. Systematic errors of sensors enter with their prior, see addBiasLogPrior().
using LogPosterior = std::function<void(ParticleSet&)>;

/// Moves every particle by steps that leave the posterior as it is (resample-move: Gilks and Berzuini, J. R. Stat. Soc.
/// B 63(1), 2001; the steps: Metropolis), so that copies of few ancestors become independent draws again. Particles
/// that only the motion noise separates, as the headings of a robot at standstill that measures ranges alone, would
/// otherwise die out one after the other although no measurement contradicts them, and the right one may die with them.
///
/// Steps alternate between a random walk in pose and systematic errors of the sensors, with the covariance of the mode
/// of the particle, and a rotation to any heading about `pivot` [m, robot frame], which keeps the mean position of the
/// sensors; as many as it takes until the modes no longer grow, `most_sweeps` at most. Systematic errors of odometry
/// and the weights stay.
void moveByPosterior(ParticleSet& particles, const ModeSet& modes, const Vector2d& pivot, const LogPosterior& posterior,
                     RandomStream& random, int most_sweeps = kMostSweeps);

/// moveByPosterior() after resampling. `since_start`: all readings so far, transformed to the newest frame; they and
/// the prior over the region are the posterior. The more of them, the fewer sweeps.
void rejuvenate(ParticleSet& particles, const ParticleFilterOptions& options, std::span<const Reading> since_start,
                const WeightParticles& weight, RandomStream& random);

/// Adds the logarithm of the prior density of the systematic errors of the sensors to the log weights.
void addBiasLogPrior(ParticleSet& particles);
}  // namespace mrpt_ext
