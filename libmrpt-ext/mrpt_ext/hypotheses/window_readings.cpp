#include "mrpt_ext/hypotheses/window_readings.h"

#include <algorithm>

#include <cmath>

#include "mrpt_ext/hypotheses/landmark_measurement.h"

namespace mrpt_ext
{
bool areJoined(std::span<const Reading> readings)
{
  return std::any_of(readings.begin(), readings.end(),
                     [](const Reading& reading) { return !reading.way_covariance.isZero(0); });
}

Reading asTaken(Reading carried)
{
  if (carried.way_covariance.isZero(0)) return carried;
  carried.offset_covariance.setZero();
  const double heading_variance = carried.way_covariance(2, 2);
  for (Detection& d : carried.detections)
  {
    // Rounding must not leave nothing of a small deviation that was hidden in a large one.
    const double variance = square(d.std_bearing) - heading_variance;
    if (d.bearing) d.std_bearing = std::sqrt(std::max(variance, 1e-9 * square(d.std_bearing)));
  }
  return carried;
}

std::vector<CarriedMeasurements> carriedMeasurements(std::span<const Reading> oldest_first, const LandmarkTable& map)
{
  std::vector<CarriedMeasurements> result;
  for (const Reading& carried : oldest_first)
  {
    const Reading reading = asTaken(carried);
    CarriedMeasurements one{reading.way_covariance, poseMeasurements(identifiedSightings({&reading, 1}, map))};
    if (!one.measurements.empty()) result.push_back(std::move(one));
  }
  return result;
}

std::map<std::size_t, std::vector<CarriedSighting>> carriedSightings(std::span<const Reading> oldest_first,
                                                                     const LandmarkTable& map)
{
  std::map<std::size_t, std::vector<CarriedSighting>> result;
  for (const Reading& carried : oldest_first)
  {
    const Reading reading = asTaken(carried);
    for (const LandmarkSighting& s : identifiedSightings({&reading, 1}, map))
      result[*s.landmark].push_back(
          {s.T_robot_sensor, reading.way_covariance, s.bearing, s.range, s.std_bearing, s.std_range});
  }
  return result;
}
}  // namespace mrpt_ext
