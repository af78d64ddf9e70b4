#include "mrpt_ext/diagnosis/noise_check.h"

#include <gtest/gtest.h>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext::test_noise_check
{
namespace
{
std::vector<std::string> hintsOf(double outliers, double scatter)
{
  RandomStream random(3);
  std::map<std::string, SensorInnovations> sensors;
  SensorInnovations& laser = sensors["laser"];
  laser.clutter_probability = 0.05;
  for (int k = 0; k < 5000; ++k)
  {
    laser.detections.add(random.chance(outliers));
    laser.ranges.add(scatter * random.gaussian());
  }
  return noiseHints(sensors);
}
}  // namespace

TEST(NoiseCheck, WhatIsAsDeclaredNeedsNoWord) { EXPECT_TRUE(hintsOf(0.055, 1.1).empty()); }

TEST(NoiseCheck, MoreOutliersThanDeclaredAreToldWithTheCommand)
{
  const auto hints = hintsOf(0.12, 1);
  ASSERT_EQ(hints.size(), 1u);
  EXPECT_NE(hints[0].find("--set Sensor_laser.clutter_probability=0.1"), std::string::npos) << hints[0];
}

TEST(NoiseCheck, NoiseThatIsDeclaredTooSmallIsTold)
{
  const auto hints = hintsOf(0.05, 2);
  ASSERT_EQ(hints.size(), 1u);
  EXPECT_NE(hints[0].find("2.0 times"), std::string::npos) << hints[0];
}
}  // namespace mrpt_ext::test_noise_check
