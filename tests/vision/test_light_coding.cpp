#include "mrpt_ext/vision/light_coding.h"

#include <gtest/gtest.h>

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
}  // namespace mrpt_ext::test_light_coding
