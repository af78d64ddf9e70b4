#include "mrpt_ext/localizers/range_only_start.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
bool isIdentifiedRange(const Detection& detection)
{
  return detection.id != kNoId && detection.range && !detection.bearing;
}

bool hasOnlyRanges(const Frame& frame)
{
  return !frame.compass && frame.fixes.empty() &&
         std::all_of(frame.readings.begin(), frame.readings.end(),
                     [](const Reading& reading)
                     { return std::all_of(reading.detections.begin(), reading.detections.end(), isIdentifiedRange); });
}

/// True while the odometry since the reading is at least as accurate as its ranges.
bool isAccurate(const Reading& reading)
{
  const double odometry_variance = reading.sensor_position_covariance.trace();
  return std::all_of(reading.detections.begin(), reading.detections.end(),
                     [odometry_variance](const Detection& detection)
                     { return odometry_variance <= square(detection.std_range); });
}
}  // namespace

void RangeOnlyStart::add(const Frame& frame)
{
  if (ended_) return;
  window_.add(frame);
  reading_count_ += frame.readings.size();
  for (const Reading& reading : frame.readings) range_count_ += reading.detections.size();
  const bool too_many = reading_count_ > kMostReadings || range_count_ > kMostRanges;
  ended_ = window_.full() || too_many || !hasOnlyRanges(frame);
}

std::vector<Reading> RangeOnlyStart::readings() const
{
  if (ended_) return {};
  std::vector<Reading> all = window_.readings();
  std::erase_if(all, [](const Reading& reading) { return reading.detections.empty(); });
  return std::all_of(all.begin(), all.end(), isAccurate) ? all : std::vector<Reading>{};
}
}  // namespace mrpt_ext
