#include "mrpt_ext/hypotheses/bias_inflation.h"

#include <cmath>

namespace mrpt_ext
{
namespace
{
/// Means and variances of the errors that act on one sensor.
struct ExpectedErrors
{
  double range_offset = 0, range_scale = 0, bearing_offset = 0;
  double range_offset_variance = 0, range_scale_variance = 0, bearing_variance = 0;
};

ExpectedErrors errorsOf(const BiasModel& biases, const std::string& sensor)
{
  ExpectedErrors errors;
  for (const BiasState& bias : biases)
  {
    if (!actsOn(bias, sensor)) continue;
    const auto add = [&bias](double& mean, double& variance)
    {
      mean += bias.mean;
      variance += square(bias.std);
    };
    if (bias.kind == BiasKind::range_offset) add(errors.range_offset, errors.range_offset_variance);
    if (bias.kind == BiasKind::range_scale) add(errors.range_scale, errors.range_scale_variance);
    if (bias.kind == BiasKind::bearing_offset) add(errors.bearing_offset, errors.bearing_variance);
  }
  return errors;
}
}  // namespace

std::vector<Reading> withBiasUncertainty(std::vector<Reading> readings, const BiasModel& biases)
{
  if (biases.empty()) return readings;
  for (Reading& reading : readings)
  {
    const ExpectedErrors errors = errorsOf(biases, reading.sensor);
    for (Detection& detection : reading.detections)
    {
      if (detection.bearing)
      {
        detection.bearing = wrap(*detection.bearing - errors.bearing_offset);
        detection.std_bearing = std::sqrt(square(detection.std_bearing) + errors.bearing_variance);
      }
      if (!detection.range) continue;
      const double range = (*detection.range - errors.range_offset) / (1 + errors.range_scale);
      if (!(range > 0)) continue;  // the mean cannot be right for it
      detection.std_range = std::sqrt(square(detection.std_range) + errors.range_offset_variance +
                                      errors.range_scale_variance * square(range)) /
                            (1 + errors.range_scale);
      detection.range = range;
    }
  }
  return readings;
}
}  // namespace mrpt_ext
