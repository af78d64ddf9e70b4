#include "mrpt_ext/filter/integrity/sensor_monitors.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr double kDropped = 0.6;  // of the long average
}  // namespace

std::string sensorKey(const Reading& reading)
{
  const auto any = [&](auto member)
  {
    return std::any_of(reading.detections.begin(), reading.detections.end(),
                       [&](const Detection& d) { return (d.*member).has_value(); });
  };
  const bool bearings = any(&Detection::bearing), ranges = any(&Detection::range);
  return reading.sensor + (bearings && ranges ? " ranges and bearings" : bearings ? " bearings" : " ranges");
}

void SensorMonitors::observe(const std::string& kind, double explained_share, double expected_share,
                             std::size_t detections)
{
  const auto [entry, added] =
      kinds_.try_emplace(kind, Averages{InlierRatioMonitor(options_), InlierRatioMonitor(slowRatioOptions(options_))});
  entry->second.quick.observe(explained_share, expected_share, detections);
  entry->second.slow.observe(explained_share, expected_share, detections);
}

bool SensorMonitors::dropped() const
{
  return std::any_of(kinds_.begin(), kinds_.end(),
                     [](const auto& entry)
                     {
                       const Averages& kind = entry.second;
                       return kind.quick.suspicious() && kind.quick.average() < kDropped * kind.slow.average();
                     });
}

std::string SensorMonitors::finding() const
{
  const auto worst = std::min_element(kinds_.begin(), kinds_.end(),
                                      [](const auto& a, const auto& b)
                                      { return a.second.quick.average() < b.second.quick.average(); });
  if (worst == kinds_.end() || !worst->second.quick.suspicious()) return {};
  return worst->first + " explain only " + std::to_string(std::lround(100 * worst->second.quick.average())) +
         " % of what is expected";
}
}  // namespace mrpt_ext
