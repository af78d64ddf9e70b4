#include "mrpt_ext/configuration/simulator_config.h"

#include <gtest/gtest.h>

#include "error_message.h"
#include "mrpt_ext/configuration/simulator_keys.h"

namespace mrpt_ext::test_simulator_config
{
namespace
{
constexpr const char* kSmall = "[Map]\nlandmarks = 1 2 0.5  3 4 0\n[Path]\ntype = standstill\n";

Scenario read(const std::string& text) { return readScenario(Settings::parse(text, "my.ini", simulatorKeys())); }

std::string errorOf(const std::string& text)
{
  return testing::configurationErrorOf([&] { (void)read(text); });
}
}  // namespace

TEST(SimulatorConfig, ReadsMapPathAndOdometry)
{
  const Scenario scenario = read(
      "[Simulation]\nduration_s = 12\nrandom_seed = 5\n[Map]\nlandmarks = 1 2 0.5  3 4 0\nids = 4 9\n"
      "categories = red\n[Path]\nwaypoints = 0 0  1 0\nspeed_m_s = 0.7\nturn_rate_deg_s = 90\nclosed = no\n"
      "[Odometry]\nrate_hz = 20\nstd_phi_deg_per_m = 3\n");
  EXPECT_EQ(scenario.duration, 12);
  EXPECT_EQ(scenario.random_seed, 5U);
  ASSERT_EQ(scenario.map.landmarks.size(), 2U);
  EXPECT_EQ(scenario.map.landmarks[1].id, 9);
  EXPECT_EQ(scenario.map.landmarks[0].position, Vector3d(1, 2, 0.5));
  EXPECT_EQ(scenario.map.landmarks[1].category, "red");
  EXPECT_EQ(scenario.path.kind, PathKind::waypoints);
  EXPECT_EQ(scenario.path.waypoints.at(1), Vector2d(1, 0));
  EXPECT_NEAR(scenario.path.turn_rate, kPi / 2, 1e-12);
  EXPECT_FALSE(scenario.path.closed);
  EXPECT_EQ(scenario.odometry.rate_hz, 20);
  EXPECT_EQ(scenario.odometry.std_phi_deg_per_m, 3);
}

TEST(SimulatorConfig, ReadsSensorsObjectsAndKidnappings)
{
  const Scenario scenario =
      read(std::string(kSmall) +
           "[Sensor_left]\nkind = range_bearing\npose = 0.1 0.2 0.3 90\nstd_bearing_deg = 2\n"
           "max_range_m = 4\nidentity = category\nmax_detections = 3\n"
           "[Sensor_north]\nkind = compass\n[Object_ball]\nposition = 1 1 0\n"
           "[Kidnapping_b]\ntime_s = 20\npose = 1 2 180\n[Kidnapping_a]\ntime_s = 10\npose = 0 0 0\n");
  ASSERT_EQ(scenario.sensors.size(), 2U);
  const SimulatedSensor& left = scenario.sensors[0];
  EXPECT_EQ(left.label, "left");
  EXPECT_EQ(left.kind, SensorKind::range_bearing);
  EXPECT_NEAR(left.T_robot_sensor.phi, kPi / 2, 1e-12);
  EXPECT_EQ(left.height, 0.3);
  EXPECT_NEAR(left.std_bearing, degToRad(2), 1e-12);
  EXPECT_EQ(left.max_range, 4.0);
  EXPECT_EQ(left.identity, IdentityLevel::category);
  EXPECT_EQ(left.max_detections, 3);
  EXPECT_EQ(scenario.sensors[1].kind, SensorKind::compass);
  ASSERT_EQ(scenario.objects.size(), 1U);
  EXPECT_EQ(scenario.objects[0].category, "ball");
  EXPECT_EQ(scenario.objects[0].path.kind, PathKind::standstill);
  ASSERT_EQ(scenario.kidnappings.size(), 2U);
  EXPECT_EQ(scenario.kidnappings[0].time, 10);
  EXPECT_NEAR(std::abs(scenario.kidnappings[1].pose.phi), kPi, 1e-12);
}

TEST(SimulatorConfig, SaysWhatDoesNotFitTogether)
{
  EXPECT_EQ(errorOf("[Path]\ntype = standstill\n"),
            "my.ini: missing key 'landmarks' in [Map], expected numbers separated by blanks, each finite m");
  EXPECT_EQ(errorOf("[Map]\nlandmarks = 1 2\n"), "my.ini:2: landmarks = 1 2: expected groups of 3 numbers");
  EXPECT_EQ(errorOf("[Map]\nlandmarks = 1 2 3\nids = 1 2\n"), "my.ini:3: ids = 1 2: expected 1 numbers");
  EXPECT_EQ(errorOf(std::string(kSmall) + "[Sensor_s]\nkind = ranges\nstd_disparity_px = 1\n"),
            "my.ini:7: std_disparity_px = 1: expected baseline_focal_m_px with it");
  EXPECT_EQ(errorOf(std::string(kSmall) + "[Sensor_s]\nkind = ranges\nclutter_per_reading = 1\n"),
            "my.ini:7: clutter_per_reading = 1: expected max_range_m with it, false ranges need a limit");
  EXPECT_EQ(errorOf(std::string(kSmall) + "[Odometry]\nrate_hz = 0\n[Sensor_s]\nkind = running_fix\n"),
            "my.ini:8: kind = running_fix: a running fix needs odometry, expected [Odometry] rate_hz above 0");
  EXPECT_EQ(errorOf(std::string(kSmall) + "[Kidnapping_1]\ntime_s = 1\npose = 1 2\n"),
            "my.ini:7: pose = 1 2: expected 3 numbers");
}
}  // namespace mrpt_ext::test_simulator_config
