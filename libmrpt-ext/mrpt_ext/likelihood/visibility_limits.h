#pragma once

#include "mrpt_ext/geometry/measurement.h"

namespace mrpt_ext
{
/// Visibility: the probability that a landmark is in view, before the detection probability is applied. 1 inside the
/// declared field of view and range, 0 outside, with a ramp of 5 % of the range and 2 degrees at each rim so that
/// weights do not jump. Each factor is clamp(offset - slope * value, 0, 1); what is not declared has slope 0.
struct VisibilityLimits
{
  static constexpr double kRangeRamp = 0.05;             ///< share of the range limit
  static constexpr double kBearingRamp = degToRad(2.0);  ///< beyond each rim of the field of view

  double range_offset = 2, range_slope = 0;      ///< of the slant range [m]
  double bearing_offset = 2, bearing_slope = 0;  ///< of the absolute bearing [rad] from the sensor's forward axis

  VisibilityLimits() = default;
  explicit VisibilityLimits(const SensorModel& model)
  {
    if (model.max_range)
    {
      range_offset = (1 + kRangeRamp) / (2 * kRangeRamp);
      range_slope = 1 / (2 * kRangeRamp * *model.max_range);
    }
    if (model.has_field_of_view && model.field_of_view < kTwoPi)
    {
      bearing_offset = (model.field_of_view / 2 + kBearingRamp) / (2 * kBearingRamp);
      bearing_slope = 1 / (2 * kBearingRamp);
    }
  }

  [[nodiscard]] bool limitsRange() const { return range_slope > 0; }
  [[nodiscard]] bool limitsBearing() const { return bearing_slope > 0; }
  [[nodiscard]] bool any() const { return limitsRange() || limitsBearing(); }
};
}  // namespace mrpt_ext
