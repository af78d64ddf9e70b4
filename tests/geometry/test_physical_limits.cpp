#include "mrpt_ext/geometry/physical_limits.h"

#include <gtest/gtest.h>

#include <limits>

namespace mrpt_ext::test_physical_limits
{
namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
}

TEST(PhysicalLimits, WhatIsOnEarthIsPossible)
{
  EXPECT_EQ(whyImpossible(OdometryRecord{1.7e9, {5e5, 9.9e6, 3}}), "") << "a projected coordinate";
  EXPECT_EQ(whyImpossible(Reading{}), "");
  EXPECT_EQ(whyImpossible(RunningFixReading{}), "");
  EXPECT_EQ(whyImpossible(CompassRecord{}), "");
}

TEST(PhysicalLimits, NamesWhatIsBeyond)
{
  EXPECT_EQ(whyImpossible(OdometryRecord{0, {1e155, 0, 0}}),
            "odometry at 1e+155 m, expected at most 1e+08 m either way");
  EXPECT_EQ(whyImpossible(OdometryRecord{1e12, {}}), "time 1e+12 s, expected at most 1e+11 s either way");
  EXPECT_NE(whyImpossible(OdometryRecord{kNan, {}}), "");
  EXPECT_NE(whyImpossible(OdometryRecord{0, {0, kNan, 0}}), "");
  Reading reading;
  reading.sensor_height = -1e9;
  EXPECT_EQ(whyImpossible(reading), "sensor on the robot at -1e+09 m, expected at most 1e+08 m either way");
  RunningFixReading fix;
  fix.displacement.y = 1e200;
  EXPECT_EQ(whyImpossible(fix), "displacement of 1e+200 m, expected at most 1e+08 m either way");
  fix.displacement.y = 0;
  fix.first_time = -1e300;
  EXPECT_NE(whyImpossible(fix), "");
}
}  // namespace mrpt_ext::test_physical_limits
