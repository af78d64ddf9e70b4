#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "mrpt_ext/geometry/recording.h"

namespace mrpt_ext
{
/// Records in the order of time, one per call; nothing at the end.
using RecordStream = std::function<std::optional<Record>()>;

/// The records must outlive the stream.
[[nodiscard]] inline RecordStream streamOf(const std::vector<Record>& records)
{
  return [&records, next = std::size_t{0}]() mutable
  { return next < records.size() ? std::optional(records[next++]) : std::nullopt; };
}
}  // namespace mrpt_ext
