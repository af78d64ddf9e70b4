#include "mrpt_ext/hypotheses/window_scans.h"

#include <algorithm>

#include "mrpt_ext/correspondence/local_map/local_map.h"
#include "mrpt_ext/hypotheses/scans.h"
#include "mrpt_ext/hypotheses/window_readings.h"

namespace mrpt_ext
{
std::vector<PastScan> carriedPlaces(std::span<const Reading> oldest_first, const LandmarkTable& map,
                                    const LandmarkIndex& index)
{
  std::vector<PastScan> places;
  for (const Reading& carried : oldest_first)
  {
    const Reading reading = withoutOdometryNoise(carried);
    for (Scan& place : scansOf({&reading, 1}, map, index))
      places.push_back({std::move(place), reading.odometry_covariance});
  }
  return places;
}

std::vector<Scan> windowScans(std::span<const Reading> oldest_first, const LandmarkTable& map,
                              const LandmarkIndex& index)
{
  if (!isWindow(oldest_first)) return scansOf(oldest_first, map, index);
  return asScans(buildLocalMap(carriedPlaces(oldest_first, map, index)));
}
}  // namespace mrpt_ext
