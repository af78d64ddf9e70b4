#pragma once

#include <span>

#include "mrpt_ext/geometry/recording.h"
#include "mrpt_ext/likelihood/pose_batch.h"

namespace mrpt_ext
{
/// Adds log((1 - e) N(heading; phi_i, std) + e / 2 pi), e = 0.05, for every pose i. The residual is wrapped.
void addCompassLogLikelihood(const CompassRecord& compass, const PoseBatch& robots, std::span<float> log_likelihood);
}  // namespace mrpt_ext
