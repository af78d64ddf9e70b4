#include "mrpt_ext/hypotheses/window_readings.h"

#include <algorithm>

#include <cmath>

#include "mrpt_ext/hypotheses/landmark_measurement.h"

namespace mrpt_ext
{
bool isWindow(std::span<const Reading> readings)
{
  return std::any_of(readings.begin(), readings.end(),
                     [](const Reading& reading) { return !reading.odometry_covariance.isZero(0); });
}

Reading withoutOdometryNoise(Reading carried)
{
  if (carried.odometry_covariance.isZero(0)) return carried;
  carried.sensor_position_covariance.setZero();
  const double heading_variance = carried.odometry_covariance(2, 2);
  for (Detection& d : carried.detections)
  {
    // Rounding must not leave nothing of a small deviation that was hidden in a large one.
    const double variance = square(d.std_bearing) - heading_variance;
    if (d.bearing) d.std_bearing = std::sqrt(std::max(variance, 1e-9 * square(d.std_bearing)));
  }
  return carried;
}

std::vector<WindowMeasurements> windowMeasurements(std::span<const Reading> oldest_first, const LandmarkTable& map)
{
  std::vector<WindowMeasurements> result;
  for (const Reading& carried : oldest_first)
  {
    const Reading reading = withoutOdometryNoise(carried);
    WindowMeasurements one{reading.odometry_covariance, poseMeasurements(identifiedSightings({&reading, 1}, map))};
    if (!one.measurements.empty()) result.push_back(std::move(one));
  }
  return result;
}

std::map<std::size_t, std::vector<WindowObservation>> windowObservations(std::span<const Reading> oldest_first,
                                                                         const LandmarkTable& map)
{
  std::map<std::size_t, std::vector<WindowObservation>> result;
  for (const Reading& carried : oldest_first)
  {
    const Reading reading = withoutOdometryNoise(carried);
    for (const LandmarkMeasurement& s : identifiedSightings({&reading, 1}, map))
      result[*s.landmark].push_back(
          {s.T_robot_sensor, reading.odometry_covariance, s.bearing, s.range, s.std_bearing, s.std_range});
  }
  return result;
}
}  // namespace mrpt_ext
