#include "mrpt_ext/likelihood/prepared_detection.h"

#include <algorithm>
#include <numbers>

namespace mrpt_ext
{
namespace
{
/// -log2(e) / (2 variance)
double exponentPerSquare(double variance) { return -0.5 * std::numbers::log2e / variance; }

/// Noise below this is beyond single precision.
double variance(double std) { return std::max(square(std), 1e-14); }
}  // namespace

double peakOf(const Detection& detection, double clutter)
{
  double peak = 1 - clutter;
  if (detection.bearing) peak /= std::sqrt(kTwoPi * variance(detection.std_bearing));
  if (detection.range) peak /= std::sqrt(kTwoPi * variance(detection.std_range));
  return peak;
}

PreparedDetection prepareDetection(const Detection& detection, const Landmark& landmark, double clutter,
                                   const ScoringFrame& frame)
{
  const double rise = frame.horizontal_range ? 0.0 : landmark.position.z() - frame.sensor_height;
  const double bearing = detection.bearing.value_or(0), range = detection.range.value_or(0);
  const double var_bearing = variance(detection.std_bearing), var_range = variance(detection.std_range);
  return {.landmark_x = static_cast<float>(landmark.position.x() - frame.origin.x()),
          .landmark_y = static_cast<float>(landmark.position.y() - frame.origin.y()),
          .rise2 = static_cast<float>(square(rise)),
          .ray_x = static_cast<float>(std::cos(bearing)),
          .ray_y = static_cast<float>(std::sin(bearing)),
          .range = static_cast<float>(range),
          .bearing_factor = detection.bearing ? static_cast<float>(exponentPerSquare(var_bearing)) : 0.0F,
          .range_factor = detection.range ? static_cast<float>(exponentPerSquare(var_range)) : 0.0F,
          .var_bearing = static_cast<float>(var_bearing),
          .var_range = static_cast<float>(var_range),
          .map_xx = static_cast<float>(square(landmark.stddev.x())),
          .map_yy = static_cast<float>(square(landmark.stddev.y())),
          .inlier_probability = static_cast<float>(1 - clutter),
          .peak = static_cast<float>(peakOf(detection, clutter))};
}
}  // namespace mrpt_ext
