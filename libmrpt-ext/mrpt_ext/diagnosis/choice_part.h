#pragma once

#include <cmath>
#include <vector>

#include "mrpt_ext/calibration/self_calibration.h"

namespace mrpt_ext
{
enum class PartKind
{
  errors,
  bearing_noise,
  range_noise,
  outliers,
  odometry_noise
};

/// A part of a calibration that is adopted as a whole.
struct ChoicePart
{
  PartKind kind = PartKind::errors;
  std::vector<std::size_t> errors;  ///< numbers of unknowns
  std::size_t sensor = 0;
  MotionNoise odometry = position_noise;
};

[[nodiscard]] constexpr bool isLandmarkOffset(const CalibrationUnknown& unknown)
{
  return unknown.parameter == CalibrationParameter::landmark_offset;
}
[[nodiscard]] constexpr bool isMapError(const CalibrationUnknown& unknown) { return isOfMap(unknown.parameter); }
[[nodiscard]] constexpr bool isPlaceError(const CalibrationUnknown& unknown) { return isLeverArm(unknown.parameter); }
/// True for errors that have to pay by themselves: lever arms, which the filters know to be uncertain, and turns in
/// place that err by themselves, which is rare, and then tell little of the other turns.
[[nodiscard]] constexpr bool paysAlone(const CalibrationUnknown& unknown)
{
  return isPlaceError(unknown) || unknown.parameter == CalibrationParameter::pivot_scale;
}
/// True for what makes ranges of a sensor wrong, whatever their landmark.
[[nodiscard]] constexpr bool isRangeError(const CalibrationUnknown& unknown)
{
  return isOfAllRanges(unknown.parameter) || unknown.parameter == CalibrationParameter::range_axis;
}

/// True for errors that are only told together, and so make one part.
[[nodiscard]] constexpr bool belongTogether(const CalibrationUnknown& a, const CalibrationUnknown& b)
{
  if (isOfDistances(a.parameter) && isOfDistances(b.parameter)) return true;
  const bool of_ranges = isOfAllRanges(a.parameter) && isOfAllRanges(b.parameter);
  return a.sensor == b.sensor && (of_ranges || (isLandmarkOffset(a) && isLandmarkOffset(b)) ||
                                  (isMapError(a) && isMapError(b) && a.landmark == b.landmark));
}

/// How many of its standard deviations an error is; 0 where there is none.
[[nodiscard]] inline double strengthOf(const ParameterEstimate& error)
{
  return error.value != 0 ? std::abs(error.value) / error.std : 0;
}

/// Numbers of what is estimated beside the `chosen` ones of `unknowns` where ranges of a sensor err: offsets of its
/// landmarks, which share only what they agree on, and its place, since ranges to what is ahead are too long for a
/// sensor further back, too.
[[nodiscard]] std::vector<std::size_t> estimatedBeside(const std::vector<std::size_t>& chosen,
                                                       const std::vector<CalibrationUnknown>& unknowns);
}  // namespace mrpt_ext
