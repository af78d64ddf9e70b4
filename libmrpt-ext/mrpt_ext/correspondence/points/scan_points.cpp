#include "mrpt_ext/correspondence/points/scan_points.h"

#include <algorithm>

namespace mrpt_ext
{
std::vector<ScanPoint> gatherPoints(std::span<const Scan> scans, double gate)
{
  struct Gathered
  {
    ScanPoint point;
    std::size_t last_scan;
  };
  std::vector<Gathered> gathered;
  for (std::size_t p = 0; p < scans.size(); ++p)
    for (const AnonymousDetection& d : scans[p].detections)
    {
      if (!d.bearing || !d.range || d.category == kUnknownCategory) continue;
      const Vector2d offset = *d.range * Vector2d(std::cos(*d.bearing), std::sin(*d.bearing));
      const ScanPoint point{transform(scans[p].T_robot_sensor, offset), std::max(d.std_range, *d.range * d.std_bearing),
                            d.std_range * *d.range * d.std_bearing, d.category};
      const auto twin =
          std::find_if(gathered.begin(), gathered.end(),
                       [&](const Gathered& g)
                       {
                         return g.last_scan != p && g.point.category == point.category &&
                                (g.point.in_robot - point.in_robot).norm() <= gate * std::hypot(g.point.std, point.std);
                       });
      if (twin == gathered.end())
      {
        gathered.push_back({point, p});
        continue;
      }
      const double w = 1 / square(twin->point.std), v = 1 / square(point.std);
      twin->point.in_robot = (w * twin->point.in_robot + v * point.in_robot) / (w + v);
      twin->point.std = 1 / std::sqrt(w + v);
      twin->point.spread *= v > 0 ? w / (w + v) : 1;
      twin->last_scan = p;
    }
  std::vector<ScanPoint> points;
  points.reserve(gathered.size());
  for (const Gathered& g : gathered) points.push_back(g.point);
  return points;
}
}  // namespace mrpt_ext
