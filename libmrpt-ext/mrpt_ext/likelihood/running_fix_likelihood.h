#pragma once

#include <vector>

#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// A running fix as the readings that carry its information, both relative to the second robot pose (paper 004 sec. 2):
/// the second range (and bearing) as measured, and the first range taken from where the sensor was then, its variance
/// grown by u^T S_d u with S_d the displacement covariance and u the line of sight.
/// Score them only when the single ranges are not in the log themselves.
[[nodiscard]] std::vector<Reading> asReadings(const RunningFixReading& fix);
/// All readings of a frame to score: its own, and those of the running fixes whose single ranges are not
/// logged as well.
[[nodiscard]] std::vector<Reading> scoredReadings(const Frame& frame);
}  // namespace mrpt_ext
