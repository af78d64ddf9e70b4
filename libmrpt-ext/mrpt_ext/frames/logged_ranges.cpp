#include "mrpt_ext/frames/logged_ranges.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
void LoggedRanges::add(const Reading& reading)
{
  if (!span_) return;
  for (const Detection& d : reading.detections)
    if (d.range) ranges_[d.id].emplace(reading.time, LoggedRange{reading.sensor, *d.range});
}

bool LoggedRanges::holds(const RunningFixReading& fix) const
{
  return holds(fix, fix.first_time, fix.first_range) || holds(fix, fix.time, fix.second_range);
}

bool LoggedRanges::holds(const RunningFixReading& fix, double time, double range) const
{
  constexpr double kSameRange = 1e-3;  // m
  const auto of_landmark = ranges_.find(fix.id);
  if (of_landmark == ranges_.end()) return false;
  return std::any_of(
      of_landmark->second.lower_bound(time - kSameTime), of_landmark->second.upper_bound(time + kSameTime),
      [&](const auto& entry)
      { return entry.second.sensor == fix.sensor || std::abs(entry.second.range - range) < kSameRange; });
}

void LoggedRanges::forgetBefore(double time)
{
  constexpr double kMargin = 1;  // s
  if (!span_) return;
  for (auto& [id, ranges] : ranges_) ranges.erase(ranges.begin(), ranges.lower_bound(time - *span_ - kMargin));
}
}  // namespace mrpt_ext
