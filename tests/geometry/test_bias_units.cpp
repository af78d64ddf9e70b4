#include "mrpt_ext/geometry/bias_units.h"

#include <gtest/gtest.h>

#include <string>

namespace mrpt_ext::test_bias_units
{
TEST(BiasUnits, EveryKindHasItsRow)
{
  for (const BiasUnit& row : kBiasUnits) EXPECT_EQ(unitOf(row.kind).name, row.name);
  EXPECT_STREQ(unitOf(BiasKind::rotation_scale).name, "odometry_rotation_scale");
}

TEST(BiasUnits, AnglesAreDegreesInFiles)
{
  EXPECT_STREQ(unitOf(BiasKind::bearing_offset).unit, "deg");
  EXPECT_STREQ(unitOf(BiasKind::drift).suffix, "_deg_per_s");
  for (const BiasUnit& row : kBiasUnits)
  {
    const std::string unit = row.unit, suffix = row.suffix;
    EXPECT_NEAR(row.factor, unit.starts_with("deg") ? 57.29578 : 1, 1e-5) << row.name;
    EXPECT_EQ(suffix.substr(0, suffix.find("_per_")), unit.empty() ? "" : "_" + unit.substr(0, unit.find('/')));
  }
}
}  // namespace mrpt_ext::test_bias_units
