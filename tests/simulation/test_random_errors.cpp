#include "mrpt_ext/simulation/random_errors.h"

#include <gtest/gtest.h>

namespace mrpt_ext::test_random_errors
{
namespace
{
Scenario scenarioWithSpread(std::uint64_t seed)
{
  Scenario scenario;
  scenario.random_seed = seed;
  scenario.sensors = {{.label = "a"}, {.label = "b", .delay_s = 0.5}};
  scenario.spread = {.drift = 0.01,
                     .arc_turn_loss = 0.4,
                     .noise_factor = 3,
                     .slips_per_minute = 2,
                     .delay = 0.1,
                     .lever_arm = 0.2,
                     .distance_scale = 0.05,
                     .rotation_scale = 0.06,
                     .veer = 0.03,
                     .bearing_offset = 0.04,
                     .range_offset = 0.3,
                     .range_scale = 0.02};
  return scenario;
}
}  // namespace

TEST(RandomErrors, WithoutSpreadNothingChanges)
{
  Scenario scenario = scenarioWithSpread(1);
  scenario.spread = {};
  const Scenario drawn = withRandomErrors(scenario);
  EXPECT_EQ(drawn.odometry.drift, 0);
  EXPECT_EQ(drawn.odometry.arc_scale_error, 0);
  EXPECT_EQ(drawn.odometry.std_xy_per_m, scenario.odometry.std_xy_per_m);
  EXPECT_EQ(drawn.odometry.slips_per_minute, 0);
  EXPECT_EQ(drawn.sensors[1].delay_s, 0.5);
  EXPECT_EQ(drawn.sensors[0].lever_arm, Vector2d::Zero());
  EXPECT_EQ(drawn.odometry.scale_error, 0);
  EXPECT_EQ(drawn.odometry.veer, 0);
  EXPECT_EQ(drawn.sensors[0].scale_range, 1);
}

TEST(RandomErrors, AreDrawnWithinTheirSpread)
{
  const OdometryNoise stated;
  double least_drift = 1, most_loss = 0, most_noise = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
  {
    const Scenario drawn = withRandomErrors(scenarioWithSpread(seed));
    const double loss = 1 - 1 / (1 + drawn.odometry.arc_scale_error);
    const double noise = drawn.odometry.std_phi_deg_per_m / stated.std_phi_deg_per_m;
    EXPECT_LE(std::abs(drawn.odometry.drift), 0.01);
    EXPECT_TRUE(loss >= 0 && loss <= 0.4) << loss;
    EXPECT_TRUE(noise >= 1 && noise <= 3) << noise;
    EXPECT_NEAR(drawn.odometry.std_xy_per_m, noise * stated.std_xy_per_m, 1e-12);
    EXPECT_TRUE(drawn.odometry.slips_per_minute >= 0 && drawn.odometry.slips_per_minute <= 2);
    EXPECT_TRUE(drawn.sensors[1].delay_s >= 0.5 && drawn.sensors[1].delay_s <= 0.6);
    EXPECT_LE(drawn.sensors[0].lever_arm.cwiseAbs().maxCoeff(), 0.2);
    EXPECT_NE(drawn.sensors[0].lever_arm, drawn.sensors[1].lever_arm);
    EXPECT_LE(std::abs(drawn.odometry.scale_error), 0.05);
    EXPECT_LE(std::abs(drawn.odometry.rotation_scale_error), 0.06);
    EXPECT_LE(std::abs(drawn.odometry.veer), 0.03);
    for (const SimulatedSensor& sensor : drawn.sensors)
    {
      EXPECT_LE(std::abs(sensor.bias_bearing), 0.04);
      EXPECT_LE(std::abs(sensor.bias_range), 0.3);
      EXPECT_LE(std::abs(sensor.scale_range - 1), 0.02);
    }
    EXPECT_NE(drawn.sensors[0].bias_range, drawn.sensors[1].bias_range);
    least_drift = std::min(least_drift, drawn.odometry.drift);
    most_loss = std::max(most_loss, loss);
    most_noise = std::max(most_noise, noise);
  }
  EXPECT_LT(least_drift, -0.008);
  EXPECT_GT(most_loss, 0.35);
  EXPECT_GT(most_noise, 2.8);
}

TEST(RandomErrors, BelongToTheSeed)
{
  const Scenario a = withRandomErrors(scenarioWithSpread(7)), b = withRandomErrors(scenarioWithSpread(7));
  EXPECT_EQ(a.odometry.drift, b.odometry.drift);
  EXPECT_NE(a.odometry.drift, withRandomErrors(scenarioWithSpread(8)).odometry.drift);
}
}  // namespace mrpt_ext::test_random_errors
