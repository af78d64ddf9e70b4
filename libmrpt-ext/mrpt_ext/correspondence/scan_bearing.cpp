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

bool areUsable(std::span<const Scan> scans)
{
  return std::all_of(scans.begin(), scans.end(),
                     [](const Scan& scan)
                     {
                       return isFinite(scan.T_robot_sensor) && isUsable(scan.model) &&
                              std::all_of(scan.detections.begin(), scan.detections.end(),
                                          [](const AnonymousDetection& d) { return isUsable(d); });
                     });
}

std::vector<ScanBearing> gatherBearings(std::span<const Scan> scans)
{
  std::vector<ScanBearing> bearings;
  int detection = 0;
  for (std::size_t p = 0; p < scans.size(); ++p)
    for (const AnonymousDetection& d : scans[p].detections)
    {
      const int index = detection++;
      if (!d.bearing || d.category == kUnknownCategory) continue;
      const Vector2d direction(std::cos(*d.bearing), std::sin(*d.bearing));
      bearings.push_back({direction, wrap(*d.bearing), d.std_bearing, d.category, static_cast<int>(p), index});
    }
  return bearings;
}
}  // namespace mrpt_ext
