#include "mrpt_ext/experiment/bearing_extent.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/likelihood/visibility_limits.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kEnough = 100;  // bearings: one of a hundred more is beyond all of them
}  // namespace

void BearingExtent::add(const Frame& frame)
{
  for (const Reading& reading : frame.readings)
  {
    Sensor& sensor = sensors_[reading.sensor];
    sensor.declared = sensor.declared || reading.model.has_field_of_view;
    for (const Detection& detection : reading.detections)
    {
      if (!detection.bearing) continue;
      ++sensor.bearings;
      sensor.widest = std::max(sensor.widest, std::abs(wrap(*detection.bearing)));
    }
  }
}

std::map<std::string, double> BearingExtent::fieldsOfView() const
{
  std::map<std::string, double> result;
  for (const auto& [label, sensor] : sensors_)
  {
    if (sensor.declared || sensor.bearings < kEnough) continue;
    // What was seen is fully in view, inside of the ramp at the rim.
    const double field_of_view = 2 * (sensor.widest + VisibilityLimits::kBearingRamp);
    if (field_of_view < kTwoPi) result[label] = field_of_view;
  }
  return result;
}
}  // namespace mrpt_ext
