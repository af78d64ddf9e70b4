#include "mrpt_ext/hypotheses/bias_inflation.h"

#include <cmath>

namespace mrpt_ext
{
namespace
{
/// Means and variances of the errors that act on one sensor.
struct BiasMoments
{
  double range_offset = 0, range_scale = 0, bearing_offset = 0;
  double range_offset_variance = 0, range_scale_variance = 0, bearing_variance = 0;
};

BiasMoments momentsOf(const BiasModel& biases, const std::string& sensor)
{
  BiasMoments sum;
  for (const BiasState& bias : biases)
  {
    if (!actsOn(bias, sensor)) continue;
    const auto add = [&bias](double& mean, double& variance)
    {
      mean += bias.mean;
      variance += square(bias.std);
    };
    if (bias.kind == BiasKind::range_offset) add(sum.range_offset, sum.range_offset_variance);
    if (bias.kind == BiasKind::range_scale) add(sum.range_scale, sum.range_scale_variance);
    if (bias.kind == BiasKind::bearing_offset) add(sum.bearing_offset, sum.bearing_variance);
  }
  return sum;
}
}  // namespace

std::vector<Reading> withBiasUncertainty(std::vector<Reading> readings, const BiasModel& biases)
{
  if (biases.empty()) return readings;
  for (Reading& reading : readings)
  {
    const BiasMoments bias = momentsOf(biases, reading.sensor);
    for (Detection& detection : reading.detections)
    {
      if (detection.bearing)
      {
        detection.bearing = wrap(*detection.bearing - bias.bearing_offset);
        detection.std_bearing = std::sqrt(square(detection.std_bearing) + bias.bearing_variance);
      }
      if (detection.facing)
        detection.facing = widened(turnedBack(*detection.facing, bias.bearing_offset), bias.bearing_variance);
      if (!detection.range) continue;
      const double range = (*detection.range - bias.range_offset) / (1 + bias.range_scale);
      if (!(range > 0)) continue;  // the prior mean does not apply to it
      detection.std_range = std::sqrt(square(detection.std_range) + bias.range_offset_variance +
                                      bias.range_scale_variance * square(range)) /
                            (1 + bias.range_scale);
      detection.range = range;
    }
  }
  return readings;
}
}  // namespace mrpt_ext
