#include "mrpt_ext/frames/log_overview.h"

#include <algorithm>

namespace mrpt_ext
{
LogOverview overviewOf(const RecordStream& records, const OdometryCorrection& correction)
{
  LogOverview overview{.odometry = OdometryPath(correction), .fix_span = {}};
  while (const auto record = records())
  {
    if (const auto* pose = std::get_if<OdometryRecord>(&*record)) overview.odometry.add(*pose);
    if (const auto* fix = std::get_if<RunningFixReading>(&*record))
      overview.fix_span = std::max(overview.fix_span.value_or(0), fix->time - fix->first_time);
  }
  overview.odometry = OdometryPath(overview.odometry);  // the copy has no spare capacity
  return overview;
}
}  // namespace mrpt_ext
