#include "mrpt_ext/filter/integrity/sensor_monitors.h"

#include <algorithm>

#include "mrpt_ext/geometry/formatted.h"

namespace mrpt_ext
{
namespace
{
constexpr double kDropped = 0.6;  // fast relative to slow ratio
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

void SensorMonitors::observe(const std::string& sensor, double inlier_ratio, double expected_ratio,
                             std::size_t detections)
{
  const auto [entry, added] =
      ratios_.try_emplace(sensor, Ratios{InlierRatioMonitor::fast(options_), InlierRatioMonitor::slow(options_)});
  entry->second.fast.observe(inlier_ratio, expected_ratio, detections);
  entry->second.slow.observe(inlier_ratio, expected_ratio, detections);
}

bool SensorMonitors::dropped() const
{
  return std::any_of(ratios_.begin(), ratios_.end(),
                     [](const auto& entry)
                     {
                       const Ratios& ratios = entry.second;
                       return ratios.fast.suspicious() && ratios.fast.average() < kDropped * ratios.slow.average();
                     });
}

std::string SensorMonitors::finding() const
{
  const auto worst =
      std::min_element(ratios_.begin(), ratios_.end(),
                       [](const auto& a, const auto& b) { return a.second.fast.average() < b.second.fast.average(); });
  if (worst == ratios_.end() || !worst->second.fast.suspicious()) return {};
  return worst->first + formatted(": inlier ratio %.0f %% of the expected value", 100 * worst->second.fast.average());
}
}  // namespace mrpt_ext
