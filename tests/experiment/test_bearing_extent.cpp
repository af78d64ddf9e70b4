#include "mrpt_ext/experiment/bearing_extent.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mrpt_ext::test_bearing_extent
{
namespace
{
constexpr double kMargin = degToRad(2.0);

/// A look with a bearing [deg].
Frame look(const std::string& sensor, double bearing_deg, bool declared = false)
{
  Reading reading{.sensor = sensor};
  reading.model.has_field_of_view = declared;
  reading.detections = {{.bearing = degToRad(bearing_deg), .std_bearing = 0.01}};
  return {.readings = {reading}};
}

/// `count` bearings to either side, up to `most` [deg].
BearingExtent extentOf(double most, int count, bool declared = false)
{
  BearingExtent extent;
  for (int k = 0; k < count; ++k)
    extent.add(look("camera", most * (k % 2 == 0 ? 1 : -0.9) * k / (count - 1), declared));
  return extent;
}
}  // namespace

TEST(BearingExtent, IsThatOfTheWidestBearingToEitherSide)
{
  for (const double most : {20.0, 34.0, 90.0, 130.0})
  {
    const auto fields = extentOf(most, 201).fieldsOfView();
    ASSERT_EQ(fields.count("camera"), 1U) << most;
    EXPECT_NEAR(fields.at("camera"), 2 * (degToRad(most) + kMargin), 1e-12);
  }
}

TEST(BearingExtent, IsUnknownOfASensorThatSeesAllAroundOrHardlyAnything)
{
  EXPECT_TRUE(extentOf(179.5, 201).fieldsOfView().empty());
  EXPECT_TRUE(extentOf(30, 99).fieldsOfView().empty());
  EXPECT_TRUE(BearingExtent{}.fieldsOfView().empty());
}

TEST(BearingExtent, IsNotAskedWhereItIsDeclared) { EXPECT_TRUE(extentOf(30, 201, true).fieldsOfView().empty()); }

TEST(BearingExtent, IsThatOfEachSensor)
{
  BearingExtent extent = extentOf(30, 201);
  for (int k = 0; k <= 200; ++k) extent.add(look("omni", 1.8 * k - 180));
  for (int k = 0; k <= 200; ++k) extent.add(look("rear", 0.1 * k));
  const auto fields = extent.fieldsOfView();
  EXPECT_EQ(fields.size(), 2U);
  EXPECT_NEAR(fields.at("rear"), 2 * (degToRad(20.0) + kMargin), 1e-12);
}
}  // namespace mrpt_ext::test_bearing_extent
