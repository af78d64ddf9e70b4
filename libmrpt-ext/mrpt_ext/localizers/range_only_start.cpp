#include "mrpt_ext/localizers/range_only_start.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
bool isRange(const Detection& detection) { return detection.id != kNoId && detection.range && !detection.bearing; }

bool tellsRangesAlone(const Frame& frame)
{
  return !frame.compass && frame.fixes.empty() &&
         std::all_of(frame.readings.begin(), frame.readings.end(),
                     [](const Reading& reading)
                     { return std::all_of(reading.detections.begin(), reading.detections.end(), isRange); });
}

/// True while odometry has carried the reading no farther off than its ranges are uncertain.
bool isWellCarried(const Reading& reading)
{
  const double off = reading.sensor_position_covariance.trace();
  return std::all_of(reading.detections.begin(), reading.detections.end(),
                     [off](const Detection& detection) { return off <= square(detection.std_range); });
}
}  // namespace

void RangeOnlyStart::add(const Frame& frame)
{
  if (ended_) return;
  joiner_.add(frame);
  ranges_ += frame.readings.size();
  ended_ = joiner_.full() || ranges_ > kMostRanges || !tellsRangesAlone(frame);
}

std::vector<Reading> RangeOnlyStart::readings() const
{
  if (ended_) return {};
  std::vector<Reading> all = joiner_.readings();
  std::erase_if(all, [](const Reading& reading) { return reading.detections.empty(); });
  return std::all_of(all.begin(), all.end(), isWellCarried) ? all : std::vector<Reading>{};
}
}  // namespace mrpt_ext
