#include "mrpt_ext/calibration/parameter_limits.h"

#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr double kToldShare = 0.5;  // of the prior standard deviation of what is roughly known
// Cameras are calibrated: focal lengths to a few percent, optical axes to a few degrees.
constexpr double kAssumedBearingScaleStd = 0.05, kAssumedAxisStd = 0.05;

/// Median of a member over the ranges of a sensor.
double typical(const CalibrationProblem& problem, std::size_t sensor, double CalibrationReading::*member)
{
  std::vector<double> values;
  for (const CalibrationReading& r : problem.readings)
    if (r.is_range && r.sensor == sensor) values.push_back(r.*member);
  return values.empty() ? 1 : upperMedian(std::move(values));
}

double leverArmStd(const CalibrationProblem& problem, std::size_t sensor)
{
  return sensor < problem.lever_arm_std.size() ? problem.lever_arm_std[sensor] : kAssumedLeverArmStd;
}
}  // namespace

double priorStd(const CalibrationProblem& problem, const CalibrationUnknown& unknown)
{
  switch (unknown.parameter)
  {
    case CalibrationParameter::lever_arm_x:
    case CalibrationParameter::lever_arm_y:
      return leverArmStd(problem, unknown.sensor);
    case CalibrationParameter::bearing_scale:
      return kAssumedBearingScaleStd;
    case CalibrationParameter::range_axis:
      return kAssumedAxisStd;
    case CalibrationParameter::range_offset:
      return 30;
    case CalibrationParameter::landmark_offset:
    case CalibrationParameter::landmark_x:
    case CalibrationParameter::landmark_y:
      return typical(problem, unknown.sensor, &CalibrationReading::std);
    case CalibrationParameter::distance_scale:
    case CalibrationParameter::rotation_scale:
    case CalibrationParameter::pivot_scale:
    case CalibrationParameter::range_scale:
    case CalibrationParameter::veer:
      return 0.3;
    case CalibrationParameter::distance_per_turn:
    case CalibrationParameter::drift:
      return 0.1;
    default:
      return 1;
  }
}

double largestUsefulStd(const CalibrationProblem& problem, const CalibrationUnknown& unknown)
{
  switch (unknown.parameter)
  {
    case CalibrationParameter::delay:
      return 0.1;
    case CalibrationParameter::lever_arm_x:
    case CalibrationParameter::lever_arm_y:
      return kToldShare * leverArmStd(problem, unknown.sensor);
    case CalibrationParameter::bearing_scale:
      return kToldShare * kAssumedBearingScaleStd;
    case CalibrationParameter::range_axis:
      return kToldShare * kAssumedAxisStd;
    case CalibrationParameter::bearing_offset:
      return degToRad(3.0);
    case CalibrationParameter::range_offset:
    case CalibrationParameter::landmark_offset:
    case CalibrationParameter::landmark_x:
    case CalibrationParameter::landmark_y:
      return 0.05 * typical(problem, unknown.sensor, &CalibrationReading::value);
    case CalibrationParameter::range_scale:
    case CalibrationParameter::veer:
      return 0.05;
    case CalibrationParameter::distance_per_turn:
      return 0.02;
    case CalibrationParameter::drift:
      return degToRad(1.0);
    case CalibrationParameter::distance_scale:
    case CalibrationParameter::rotation_scale:
    case CalibrationParameter::pivot_scale:
      return 0.1;
    case CalibrationParameter::range_height:
      break;  // a mistake in the map, which is no value of the configuration
  }
  return 0;
}
}  // namespace mrpt_ext
