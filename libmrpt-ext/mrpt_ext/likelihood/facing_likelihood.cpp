#include "mrpt_ext/likelihood/facing_likelihood.h"

#include <algorithm>

#include "mrpt_ext/geometry/work_counter.h"
#include "mrpt_ext/likelihood/detection_density.h"

namespace mrpt_ext
{
std::optional<Facing> headingFromFacing(const Detection& detection, const Reading& reading, const LandmarkTable& map,
                                        double bearing_offset)
{
  if (!detection.facing) return std::nullopt;
  const auto landmark = map.indexOf(detection.id);
  if (!landmark || !map[*landmark].yaw) return std::nullopt;
  // heading + mounting + seen direction = direction in the map
  Facing headings = widened(*detection.facing, square(map[*landmark].std_yaw));
  const double sum = *map[*landmark].yaw - reading.T_robot_sensor.phi + bearing_offset;
  for (Facing::Attitude& attitude : headings.attitudes) attitude.yaw = wrap(sum - attitude.yaw);
  return headings;
}

double facingDensity(const Facing& headings, double heading, double clutter_probability)
{
  const double clutter = boundedClutter(clutter_probability);
  double density = 0;
  for (const Facing::Attitude& attitude : headings.attitudes)
    if (attitude.weight > 0)
      density += attitude.weight / (attitude.std * std::sqrt(kTwoPi)) *
                 std::exp(-0.5 * square(wrap(heading - attitude.yaw) / attitude.std));
  return (1 - clutter) * density + clutter / kTwoPi;
}

double facingLogLikelihood(const Reading& reading, const LandmarkTable& map, const Pose2& robot, const SensorBias& bias)
{
  double sum = 0;
  for (const Detection& detection : reading.detections)
    if (const auto headings = headingFromFacing(detection, reading, map, bias.bearing_offset))
      sum += std::log(facingDensity(*headings, robot.phi, reading.model.clutter_probability));
  return sum;
}

void addFacingLogLikelihood(const Reading& reading, const LandmarkTable& map, const PoseBatch& robots,
                            std::span<float> log_likelihood)
{
  constexpr std::size_t kCost = 30;  // of a robot, in operations (work_counter.h)
  for (const Detection& detection : reading.detections)
  {
    const auto headings = headingFromFacing(detection, reading, map);
    if (!headings) continue;
    WorkCounter::add(kCost * robots.size());
    for (std::size_t i = 0; i < robots.size(); ++i)
    {
      // An offset turns all headings, as if the robot were turned back.
      const double offset = robots.bias_states.empty() ? 0 : sensorBias(robots, i, reading.sensor).bearing_offset;
      const double density =
          facingDensity(*headings, double{robots.phi[i]} - offset, reading.model.clutter_probability);
      log_likelihood[i] += static_cast<float>(std::log(density));
    }
  }
}
}  // namespace mrpt_ext
