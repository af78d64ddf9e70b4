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

/// What a recording holds, one line per kind of record, sensor, truth and map: numbers, rates [1/s] and longest gaps
/// [s].
[[nodiscard]] std::vector<std::string> describe(const Recording& recording);
}  // namespace mrpt_ext
