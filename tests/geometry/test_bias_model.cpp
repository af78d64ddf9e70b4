#include "mrpt_ext/geometry/bias_model.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_bias_model
{
TEST(BiasModel, ASensorsErrorActsOnItsPartsAfterADot)
{
  const BiasState camera{.kind = BiasKind::bearing_offset, .sensor = "camera"};
  for (const char* label : {"camera", "camera.4", "camera.left.low"}) EXPECT_TRUE(actsOn(camera, label)) << label;
  for (const char* label : {"", "cam", "camera4", "camera_left", "sonar", "left.camera"})
    EXPECT_FALSE(actsOn(camera, label)) << label;
}

TEST(BiasModel, AnErrorOfAllSensorsActsOnEachAndOneOfOdometryOnNone)
{
  EXPECT_TRUE(actsOn({.kind = BiasKind::range_scale, .sensor = ""}, "sonar"));
  EXPECT_FALSE(actsOn({.kind = BiasKind::distance_scale, .sensor = ""}, "sonar"));
}
}  // namespace mrpt_ext::test_bias_model
