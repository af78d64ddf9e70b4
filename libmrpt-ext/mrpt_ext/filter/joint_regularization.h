#pragma once

#include <vector>

#include "mrpt_ext/filter/modes/modes.h"
#include "mrpt_ext/filter/particles/particle_set.h"
#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// regularizeModes() for particles that carry systematic errors: pose and errors are moved together, with their joint
/// covariance. A constant error would otherwise soon have one value only, that of the few survivors.
void regularizeJointly(ParticleSet& particles, const std::vector<Mode>& compact, double bandwidth,
                       RandomStream& random);
}  // namespace mrpt_ext
