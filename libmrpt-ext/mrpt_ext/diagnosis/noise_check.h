#pragma once

#include <map>
#include <string>
#include <vector>

#include "mrpt_ext/diagnosis/innovation_observer.h"

namespace mrpt_ext
{
/// A line for each sensor with significantly more outliers than `clutter_probability` declares, or with innovations
/// that are larger than the declared noise of sensor and odometry: what it is, and the command that helps.
[[nodiscard]] std::vector<std::string> noiseHints(const std::map<std::string, SensorInnovations>& sensors);
}  // namespace mrpt_ext
