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
  for (const BiasUnit& row : kBiasUnits)
  {
    const bool angle = row.kind == BiasKind::bearing_offset;
    EXPECT_NEAR(row.factor, angle ? 57.29578 : 1, 1e-5) << row.name;
    EXPECT_EQ(row.unit == std::string("deg"), angle) << row.name;
    EXPECT_EQ(std::string(row.suffix), *row.unit == '\0' ? "" : std::string("_") + row.unit);
  }
}
}  // namespace mrpt_ext::test_bias_units
