#include "mrpt_ext/correspondence/scan_bearing.h"

#include <algorithm>

namespace mrpt_ext
{
namespace
{
bool isUsable(const AnonymousDetection& d)
{
  if (d.bearing && !(std::isfinite(*d.bearing) && std::isfinite(d.std_bearing) && d.std_bearing > 0)) return false;
  if (d.range && !(*d.range >= 0 && std::isfinite(*d.range) && std::isfinite(d.std_range) && d.std_range > 0))
    return false;
  return true;
}

bool isUsable(const SensorModel& model)
{
  const auto probability = [](double p) { return p >= 0 && p <= 1; };
  return probability(model.clutter_probability) && probability(model.detection_probability.value_or(1)) &&
         model.max_range.value_or(1) > 0;
}
}  // namespace

bool areUsable(std::span<const Scan> places)
{
  return std::all_of(places.begin(), places.end(),
                     [](const Scan& place)
                     {
                       return isFinite(place.T_robot_sensor) && isUsable(place.model) &&
                              std::all_of(place.detections.begin(), place.detections.end(),
                                          [](const AnonymousDetection& d) { return isUsable(d); });
                     });
}

std::vector<ScanBearing> gatherBearings(std::span<const Scan> places)
{
  std::vector<ScanBearing> readings;
  int detection = 0;
  for (std::size_t p = 0; p < places.size(); ++p)
    for (const AnonymousDetection& d : places[p].detections)
    {
      const int index = detection++;
      if (!d.bearing || d.kind == kUnknownCategory) continue;
      const Vector2d direction(std::cos(*d.bearing), std::sin(*d.bearing));
      readings.push_back({direction, wrap(*d.bearing), d.std_bearing, d.kind, static_cast<int>(p), index});
    }
  return readings;
}
}  // namespace mrpt_ext
