#include "mrpt_ext/diagnosis/systematic_error_check.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_systematic_error_check
{
TEST(SystematicErrorCheck, NamesSensorDelayAndCommand)
{
  EXPECT_EQ(
      delayHint(DelayFinding{0.081, 3.0}, {"camera"}),
      "camera: detections are about 0.08 s older than odometry at their stamps (delay: innovations grow with speed): "
      "see --diagnose, set it with --calibrate FILE.ini");
  EXPECT_TRUE(delayHint(DelayFinding{-0.1, 3.0}, {"left", "right"}).starts_with("detections are about 0.10 s younger"));
}

TEST(SystematicErrorCheck, SignsAreWords)
{
  const auto hints = systematicErrorHints({{{CalibrationParameter::range_scale, 0}, -0.03, 0.001, 2.0},
                                           {{CalibrationParameter::distance_scale}, 0.05, 0.002, 2.0}},
                                          {"uwb"});
  ASSERT_EQ(hints.size(), 2u);
  EXPECT_TRUE(hints[0].starts_with("uwb: ranges are 3.0 +- 0.1 % too short")) << hints[0];
  EXPECT_TRUE(hints[1].starts_with("odometry: distances are 5.0 +- 0.2 % too short")) << hints[1];
}

TEST(SystematicErrorCheck, ADriftIsToldPerSecond)
{
  const auto hints = systematicErrorHints({{{CalibrationParameter::drift}, degToRad(-0.4), degToRad(0.02), 2.0}}, {});
  ASSERT_EQ(hints.size(), 1u);
  EXPECT_TRUE(hints[0].starts_with("odometry: it does not see a turn of 0.400 +- 0.020 deg per second to the right"))
      << hints[0];
}

TEST(SystematicErrorCheck, AHeightIsNamedWithoutACommandThatCannotTellIt)
{
  const auto hints = systematicErrorHints({{{CalibrationParameter::range_height, 0}, 4.0, 0.1, 2.0},
                                           {{CalibrationParameter::range_offset, 0}, -0.5, 0.1, 2.0},
                                           {{CalibrationParameter::range_height, 1}, -2.25, 0.1, 2.0}},
                                          {"uwb", "radar"});
  ASSERT_EQ(hints.size(), 2u);
  EXPECT_NE(hints[0].find("as by a height of about 2.0 m between sensor and landmarks that is not stated"),
            std::string::npos)
      << hints[0];
  EXPECT_NE(hints[1].find("as if about 1.5 m of the stated height"), std::string::npos) << hints[1];
  for (const std::string& hint : hints)
  {
    EXPECT_NE(hint.find("check z in the map"), std::string::npos) << hint;
    EXPECT_EQ(hint.find("--calibrate"), std::string::npos) << hint;
  }
}

TEST(SystematicErrorCheck, AnErrorThatDoesNotMatterNeedsNoWord)
{
  EXPECT_EQ(delayHint(DelayFinding{0.01, 0.3}, {"camera"}), "");
  EXPECT_EQ(delayHint(std::nullopt, {"camera"}), "");
  EXPECT_TRUE(systematicErrorHints({{{CalibrationParameter::range_offset, 0}, 0.01, 0.0001, 0.1}}, {"uwb"}).empty());
}
}  // namespace mrpt_ext::test_systematic_error_check
