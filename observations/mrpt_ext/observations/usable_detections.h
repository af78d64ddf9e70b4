#pragma once

#include <map>
#include <string>

#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// How many detections (or whole observations) could not be used, by reason.
using UnusableCounts = std::map<std::string, std::size_t>;

/// Removes detections without measurement or with impossible values, counts them by reason, and wraps the bearings. Of
/// a detection with an impossible direction of its landmark only that is removed.
void removeUnusable(Reading& reading, UnusableCounts& counts);

/// Why the fix cannot be used; empty when it can.
[[nodiscard]] std::string whyUnusable(const RunningFixReading& fix);
}  // namespace mrpt_ext
