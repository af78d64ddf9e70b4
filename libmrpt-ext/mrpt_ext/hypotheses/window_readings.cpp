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

Reading withoutOdometryNoise(Reading propagated)
{
  if (propagated.odometry_covariance.isZero(0)) return propagated;
  propagated.sensor_position_covariance.setZero();
  const double heading_variance = propagated.odometry_covariance(2, 2);
  for (Detection& d : propagated.detections)
  {
    // The floor guards against cancellation.
    const double variance = square(d.std_bearing) - heading_variance;
    if (d.bearing) d.std_bearing = std::sqrt(std::max(variance, 1e-9 * square(d.std_bearing)));
    if (d.facing) d.facing = widened(*d.facing, -heading_variance);
  }
  return propagated;
}

std::vector<WindowMeasurements> windowMeasurements(std::span<const Reading> oldest_first, const LandmarkTable& map)
{
  std::vector<WindowMeasurements> result;
  for (const Reading& propagated : oldest_first)
  {
    const Reading reading = withoutOdometryNoise(propagated);
    WindowMeasurements one{reading.odometry_covariance, poseMeasurements(identifiedMeasurements({&reading, 1}, map))};
    if (!one.measurements.empty()) result.push_back(std::move(one));
  }
  return result;
}

std::map<std::size_t, std::vector<WindowObservation>> windowObservations(std::span<const Reading> oldest_first,
                                                                         const LandmarkTable& map)
{
  std::map<std::size_t, std::vector<WindowObservation>> result;
  for (const Reading& propagated : oldest_first)
  {
    const Reading reading = withoutOdometryNoise(propagated);
    for (const LandmarkMeasurement& m : identifiedMeasurements({&reading, 1}, map))
      result[*m.landmark].push_back(
          {m.T_robot_sensor, reading.odometry_covariance, m.bearing, m.range, m.std_bearing, m.std_range});
  }
  return result;
}
}  // namespace mrpt_ext
