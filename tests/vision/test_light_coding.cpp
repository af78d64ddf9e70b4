#include "mrpt_ext/vision/light_coding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mrpt_ext::test_light_coding
{
TEST(LightCoding, AgreesWithPixelsSummedOneByOne)
{
  // An edge at every place of a pixel: the mean coded level tells where it seems to be.
  const double dark = 60, bright = 220;
  double sum = 0;
  constexpr int kPlaces = 1000;
  for (int i = 0; i < kPlaces; ++i)
  {
    const double share = (i + 0.5) / kPlaces;
    sum += std::pow(share * std::pow(bright, 2.2) + (1 - share) * std::pow(dark, 2.2), 1 / 2.2) / kPlaces;
  }
  const double seen = (sum - dark) / (bright - dark);
  EXPECT_NEAR(shiftByCoding(dark, bright), seen - 0.5, 1e-4);
  EXPECT_EQ(shiftByCoding(dark, bright), shiftByCoding(bright, dark));
}

TEST(LightCoding, EqualOrMissingLevelsShiftNothing)
{
  EXPECT_EQ(shiftByCoding(100, 100), 0);
  EXPECT_EQ(shiftByCoding(0, 0), 0);
  EXPECT_NEAR(shiftByCoding(0, 255), 1 / (1 + 1 / 2.2) - 0.5, 1e-9);
}

TEST(LightCoding, ClippingShiftsAStepToItsDarkerSide)
{
  // A blurred step up to 5 % more than the brightest level: where the slopes of what is shown have their mean.
  for (const double dark : {20.0, 120.0, 200.0, 240.0})
  {
    double sum = 0, moment = 0;
    constexpr double kStep = 1e-3;
    const auto shown = [&](double z)
    { return std::min(255.0, dark + (1.05 * 255 - dark) * std::erfc(-z / std::sqrt(2.0)) / 2); };
    for (double z = -6; z < 6; z += kStep)
    {
      const double slope = shown(z + kStep) - shown(z);
      sum += slope, moment += (z + kStep / 2) * slope;
    }
    EXPECT_NEAR(shiftByClipping(dark), -moment / sum, 0.01) << dark;
  }
  EXPECT_GT(shiftByClipping(255), shiftByClipping(250));
}
}  // namespace mrpt_ext::test_light_coding
