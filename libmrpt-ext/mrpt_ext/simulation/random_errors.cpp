#include "mrpt_ext/simulation/random_errors.h"

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
namespace
{
constexpr std::uint64_t kErrorStream = 3;  // of the scenario's seed; others: simulated_drive.cpp

void scaleNoise(OdometryNoise& noise, double factor)
{
  noise.std_xy_per_m *= factor;
  noise.std_phi_deg_per_deg *= factor;
  noise.std_phi_deg_per_m *= factor;
  noise.std_xy_per_sqrt_s *= factor;
  noise.std_phi_deg_per_sqrt_s *= factor;
}

void drawScales(const ErrorSpread& spread, OdometryNoise& odometry, RandomStream& random)
{
  odometry.scale_error += random.uniform(-spread.distance_scale, spread.distance_scale);
  odometry.rotation_scale_error += random.uniform(-spread.rotation_scale, spread.rotation_scale);
  odometry.veer += random.uniform(-spread.veer, spread.veer);
}

void drawOffsets(const ErrorSpread& spread, SimulatedSensor& sensor, RandomStream& random)
{
  sensor.bias_bearing += random.uniform(-spread.bearing_offset, spread.bearing_offset);
  sensor.bias_range += random.uniform(-spread.range_offset, spread.range_offset);
  sensor.scale_range *= 1 + random.uniform(-spread.range_scale, spread.range_scale);
}
}  // namespace

Scenario withRandomErrors(Scenario scenario)
{
  const ErrorSpread& spread = scenario.spread;
  OdometryNoise& odometry = scenario.odometry;
  RandomStream random(scenario.random_seed, kErrorStream);
  odometry.drift += random.uniform(-spread.drift, spread.drift);
  // A robot that turns by a share less than measured: measured / true = 1 / (1 - share).
  odometry.arc_scale_error += 1 / (1 - random.uniform(0, spread.arc_turn_loss)) - 1;
  scaleNoise(odometry, random.uniform(1, spread.noise_factor));
  odometry.slips_per_minute += random.uniform(0, spread.slips_per_minute);
  for (SimulatedSensor& sensor : scenario.sensors)
  {
    sensor.delay_s += random.uniform(0, spread.delay);
    sensor.lever_arm.x() += random.uniform(-spread.lever_arm, spread.lever_arm);
    sensor.lever_arm.y() += random.uniform(-spread.lever_arm, spread.lever_arm);
  }
  drawScales(spread, odometry, random);
  for (SimulatedSensor& sensor : scenario.sensors) drawOffsets(spread, sensor, random);
  return scenario;
}
}  // namespace mrpt_ext
