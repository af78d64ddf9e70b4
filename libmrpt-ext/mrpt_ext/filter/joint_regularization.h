#pragma once

#include "mrpt_ext/filter/regularization.h"

namespace mrpt_ext
{
/// regularizeModes() for particles that carry systematic errors: pose and errors are moved together, with their common
/// covariance. An error that does not wander would otherwise soon have one value only, that of the few survivors.
void smoothJointly(ParticleSet& particles, const std::vector<Mode>& compact, double bandwidth, RandomStream& random);
}  // namespace mrpt_ext
