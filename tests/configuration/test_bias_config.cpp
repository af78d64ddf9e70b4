#include "mrpt_ext/configuration/bias_config.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext::test_bias_config
{
namespace
{
BiasModel modelOf(const std::string& text) { return biasModel(Settings::parse(text, "/a/b.ini", localizationKeys())); }
}  // namespace

TEST(BiasConfig, NothingIsEstimatedUnlessAskedFor)
{
  EXPECT_TRUE(modelOf("").empty());
  EXPECT_TRUE(modelOf("[Sensor_a]\nstd_range_m = 1\n").empty());
}

TEST(BiasConfig, EveryKindHasItsKeysInItsUnit)
{
  const BiasModel model = modelOf(
      "[Bias]\nrange_offset_std_m = 0.2\nrange_offset_mean_m = 0.1\nrange_scale_std = 0.05\nbearing_offset_std_deg = "
      "2\n"
      "bearing_offset_std_per_sqrt_s_deg = 0.1\nodometry_distance_scale_std = 0.04\nodometry_rotation_scale_std = "
      "0.03\n"
      "odometry_rotation_scale_std_per_sqrt_s = 0.001\n");
  ASSERT_EQ(model.size(), 5u);
  EXPECT_EQ(model[0].kind, BiasKind::range_offset);
  EXPECT_EQ(model[0].mean, 0.1);
  EXPECT_EQ(model[0].std, 0.2);
  EXPECT_EQ(model[1].kind, BiasKind::range_scale);
  EXPECT_EQ(model[1].std, 0.05);
  EXPECT_EQ(model[2].kind, BiasKind::bearing_offset);
  EXPECT_DOUBLE_EQ(model[2].std, degToRad(2.0));
  EXPECT_DOUBLE_EQ(model[2].std_per_sqrt_s, degToRad(0.1));
  EXPECT_EQ(model[3].kind, BiasKind::distance_scale);
  EXPECT_EQ(model[4].kind, BiasKind::rotation_scale);
  EXPECT_EQ(model[4].std_per_sqrt_s, 0.001);
  for (const BiasState& state : model) EXPECT_TRUE(state.sensor.empty());
}

TEST(BiasConfig, ASensorMayHaveErrorsOfItsOwn)
{
  const BiasModel model = modelOf(
      "[Bias]\nrange_scale_std = 0.05\n[Sensor_left]\nbearing_offset_std_deg = 1\n[Sensor_right]\n"
      "bearing_offset_mean_deg = 3\n");
  ASSERT_EQ(model.size(), 3u);
  EXPECT_EQ(model[1].sensor, "left");
  EXPECT_TRUE(actsOn(model[0], "left"));
  EXPECT_FALSE(actsOn(model[1], "right"));
  EXPECT_EQ(model[2].sensor, "right");
  EXPECT_DOUBLE_EQ(model[2].mean, degToRad(3.0));
  EXPECT_EQ(model[2].std, 0) << "known, not estimated";
}

TEST(BiasConfig, ErrorsOfASensorActOnItsPartsBesideTheirOwn)
{
  const BiasModel model =
      modelOf("[Sensor_camera]\nrange_scale_std = 0.05\n[Sensor_camera.4]\nrange_scale_std = 0.02\n");
  ASSERT_EQ(model.size(), 2u);
  for (const BiasState& state : model) EXPECT_TRUE(actsOn(state, "camera.4")) << state.sensor;
  EXPECT_EQ(std::count_if(model.begin(), model.end(), [](const BiasState& state) { return actsOn(state, "camera.3"); }),
            1);
}

TEST(BiasConfig, OdometryHasNoErrorsPerSensorAndNoDeviationIsNegative)
{
  EXPECT_THROW((void)modelOf("[Sensor_a]\nodometry_distance_scale_std = 0.1\n"), InputError);
  EXPECT_THROW((void)modelOf("[Bias]\nrange_scale_std = -0.1\n"), InputError);
}

TEST(BiasConfig, MoreErrorsThanTheFiltersHoldAreRefused)
{
  std::string text = "[Bias]\nodometry_distance_scale_std = 0.1\n";
  for (int k = 0; k < 12; ++k) text += "[Sensor_s" + std::to_string(k) + "]\nrange_scale_std = 0.1\n";
  EXPECT_EQ(modelOf(text).size(), 13u);
  EXPECT_THROW((void)modelOf(text + "[Sensor_more]\nrange_scale_std = 0.1\n"), InputError);
}

TEST(BiasConfig, TheFilterEstimatesWhatTheConfigurationNames)
{
  const LandmarkTable map({{.id = 1, .position = {0, 0, 0}}, {.id = 2, .position = {4, 4, 0}}});
  const auto config =
      localizationConfig(Settings::parse("[Bias]\nrange_scale_std = 0.05\n", "/a/b.ini", localizationKeys()), map);
  ASSERT_EQ(config.biases.size(), 1u);
  EXPECT_EQ(config.filter.biases.size(), 1u);
}
}  // namespace mrpt_ext::test_bias_config
