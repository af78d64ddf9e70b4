#pragma once

#include <vector>

#include "mrpt_ext/geometry/bias_model.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// Readings corrected by the prior means of their sensors' systematic errors, with standard deviations inflated by the
/// prior standard deviations of these errors. Needed for proposals while the errors are not estimated yet: a range that
/// may be 5 % too long locates a robot 60 m away to no better than 3 m, however low its noise; a narrower proposal
/// would miss the right pose.
[[nodiscard]] std::vector<Reading> withBiasUncertainty(std::vector<Reading> readings, const BiasModel& biases);
}  // namespace mrpt_ext
