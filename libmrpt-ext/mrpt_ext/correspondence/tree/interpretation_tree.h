#pragma once

#include <span>

#include "mrpt_ext/correspondence/tree/interpretation_types.h"

namespace mrpt_ext
{
/// All consistent interpretations of the bearings (paper 000, section 3: interpretation tree). An interpretation is
/// consistent when its maximum-likelihood pose (equal weights) leaves no residual above eps and lies inside the area
/// and within range of its landmarks; missed detections do not count. An interpretation that only
/// drops bearings from another consistent one is not listed. Where least squares converges onto a landmark, since from
/// there its bearing is arbitrary, a pose near it is taken (1e-4 of the distance to the next one).
/// Poses are those of the sensor; for one at T_robot_sensor on the robot, compose with inverse(T_robot_sensor).
/// Status: `ok` with solutions, `none` without, `too_few` when less than four bearings can be matched (three with
/// allow_three), `bad_input` for non-finite numbers, eps <= 0, or a candidate that is no landmark index.
[[nodiscard]] Interpretations interpretBearings(std::span<const Vector2d> landmarks,
                                                std::span<const AnonymousBearing> bearings,
                                                const InterpretationOptions& options);
}  // namespace mrpt_ext
