#include "mrpt_ext/diagnosis/calibration_data.h"

#include <gtest/gtest.h>

#include "recorded_choice.h"

namespace mrpt_ext::test_calibration_data
{
using testing::has;

TEST(CalibrationUnknowns, CommandsAreNotFollowedOnArcsWhereWheelsAndGyroscopesDrift)
{
  const LocalizationInput input;
  CalibrationData data;
  data.problem.odometry = {{0, {}}, {1, {1, 0, 0}}};
  for (const bool commanded : {false, true})
  {
    data.commanded = commanded;
    const std::vector<CalibrationUnknown> unknowns = calibrationUnknowns(input, data);
    EXPECT_TRUE(has(unknowns, CalibrationParameter::distance_scale));
    EXPECT_EQ(has(unknowns, CalibrationParameter::pivot_scale), commanded);
    EXPECT_TRUE(has(unknowns, CalibrationParameter::veer));
    EXPECT_EQ(has(unknowns, CalibrationParameter::distance_per_turn), commanded);
    EXPECT_EQ(has(unknowns, CalibrationParameter::drift), !commanded);
  }
  LocalizationInput configured;  // as found before
  configured.config.frames.odometry.turn_per_s = 0.01;
  EXPECT_TRUE(has(calibrationUnknowns(configured, data), CalibrationParameter::drift));
  data.problem.odometry.clear();
  EXPECT_TRUE(calibrationUnknowns(input, data).empty());
}
}  // namespace mrpt_ext::test_calibration_data
