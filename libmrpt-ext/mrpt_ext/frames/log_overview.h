#pragma once

#include <optional>

#include "mrpt_ext/geometry/odometry_path.h"
#include "mrpt_ext/geometry/record_stream.h"

namespace mrpt_ext
{
/// What must be known of the whole log before its first frame is complete.
struct LogOverview
{
  OdometryPath odometry;
  std::optional<double> fix_span;  ///< [s] longest time between the two ranges of a running fix; absent without fixes
};

/// Reads all records once.
[[nodiscard]] LogOverview overviewOf(const RecordStream& records, const OdometryCorrection& correction);
}  // namespace mrpt_ext
