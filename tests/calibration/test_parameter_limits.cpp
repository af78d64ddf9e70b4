#include "mrpt_ext/calibration/parameter_limits.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_parameter_limits
{
using Kind = CalibrationParameter;

TEST(ParameterLimits, ALeverArmIsToldWhenTheRecordingHalvesWhatWasNotKnown)
{
  const CalibrationProblem problem{.sensors = 2, .lever_arm_std = {0.2}};
  EXPECT_EQ(priorStd(problem, {Kind::lever_arm_x, 0}), 0.2);
  EXPECT_EQ(largestUsefulStd(problem, {Kind::lever_arm_y, 0}), 0.1);
  EXPECT_EQ(priorStd(problem, {Kind::lever_arm_x, 1}), 0.05);
}

TEST(ParameterLimits, WhatIsOfUseIsMoreThanWasKnown)
{
  CalibrationProblem problem{.sensors = 1};
  problem.readings.push_back({.is_range = true, .value = 8});
  for (const Kind kind : {Kind::delay, Kind::lever_arm_x, Kind::bearing_offset, Kind::range_offset, Kind::range_scale,
                          Kind::bearing_scale, Kind::range_axis, Kind::distance_scale, Kind::rotation_scale, Kind::veer,
                          Kind::drift, Kind::distance_per_turn, Kind::pivot_scale})
    EXPECT_LE(largestUsefulStd(problem, {kind}), 0.5 * priorStd(problem, {kind})) << static_cast<int>(kind);
  EXPECT_NEAR(largestUsefulStd(problem, {Kind::range_offset}), 0.4, 1e-12);
}
}  // namespace mrpt_ext::test_parameter_limits
