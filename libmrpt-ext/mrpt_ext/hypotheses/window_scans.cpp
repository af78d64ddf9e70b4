#include "mrpt_ext/hypotheses/window_scans.h"

#include <algorithm>

#include "mrpt_ext/correspondence/local_map/local_map.h"
#include "mrpt_ext/hypotheses/window_readings.h"
#include "mrpt_ext/hypotheses/scans.h"

namespace mrpt_ext
{
std::vector<CarriedPlace> carriedPlaces(std::span<const Reading> oldest_first, const LandmarkTable& map,
                                        const LandmarkIndex& index)
{
  std::vector<CarriedPlace> places;
  for (const Reading& carried : oldest_first)
  {
    const Reading reading = asTaken(carried);
    for (SensorPlace& place : sensorPlaces({&reading, 1}, map, index))
      places.push_back({std::move(place), reading.way_covariance});
  }
  return places;
}

std::vector<SensorPlace> joinedPlaces(std::span<const Reading> oldest_first, const LandmarkTable& map,
                                      const LandmarkIndex& index)
{
  if (!areJoined(oldest_first)) return sensorPlaces(oldest_first, map, index);
  return asSensorPlaces(joinPlaces(carriedPlaces(oldest_first, map, index)));
}
}  // namespace mrpt_ext
