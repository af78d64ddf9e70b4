#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// Orders the records by time; records of one stamp keep their order.
void sortByTime(Recording& recording);

/// "<n> <what>" as a note, only when something was counted.
void noteCount(Recording& recording, std::size_t count, const std::string& what);

/// Contents of a recording, one line per type of record, sensor, truth and map: numbers, rates [1/s], longest gaps
/// [s], how old the odometry is at the readings, detections that repeat an id and ids that the map does not have.
[[nodiscard]] std::vector<std::string> describe(const Recording& recording);
}  // namespace mrpt_ext
