#pragma once

#include <vector>

#include "mrpt_ext/geometry/bias_model.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// The readings as they tell places before anything is known about the systematic errors of their sensors beyond the
/// model: the means are taken off, and the deviations grow by how far the errors may lie from them. A range that may be
/// 5 % too long places a robot 60 m away no better than to 3 m, however little it scatters; a proposal that is sharper
/// misses the right place.
[[nodiscard]] std::vector<Reading> withBiasUncertainty(std::vector<Reading> readings, const BiasModel& biases);
}  // namespace mrpt_ext
