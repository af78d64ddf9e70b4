#pragma once

#include <optional>
#include <string_view>

#include "mrpt_ext/calibration/calibration_problem.h"
#include "mrpt_ext/geometry/bias_model.h"

namespace mrpt_ext
{
/// The calibration parameter that an error estimated beside the pose is; nothing where there is none.
[[nodiscard]] constexpr std::optional<CalibrationParameter> parameterOf(BiasKind kind)
{
  switch (kind)
  {
    case BiasKind::range_offset:
      return CalibrationParameter::range_offset;
    case BiasKind::range_scale:
      return CalibrationParameter::range_scale;
    case BiasKind::bearing_offset:
      return CalibrationParameter::bearing_offset;
    case BiasKind::distance_scale:
      return CalibrationParameter::distance_scale;
    case BiasKind::rotation_scale:
      return CalibrationParameter::rotation_scale;
    case BiasKind::veer:
      return CalibrationParameter::veer;
    case BiasKind::drift:
      return CalibrationParameter::drift;
    case BiasKind::arc_scale:
      break;
  }
  return std::nullopt;
}

/// True when the configured error `bias` is `unknown`; `label`: of the unknown's sensor.
[[nodiscard]] inline bool isTheSame(const BiasState& bias, const CalibrationUnknown& unknown, std::string_view label)
{
  return parameterOf(bias.kind) == unknown.parameter && (isOfOdometry(unknown.parameter) || actsOn(bias, label));
}
}  // namespace mrpt_ext
