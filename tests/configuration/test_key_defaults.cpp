#include <gtest/gtest.h>

#include "mrpt_ext/configuration/localization_config.h"
#include "mrpt_ext/configuration/localization_keys.h"
#include "mrpt_ext/configuration/sensor_sections.h"
#include "mrpt_ext/configuration/simulator_config.h"
#include "mrpt_ext/configuration/simulator_keys.h"

// An empty .ini gives what the library's structs are by default: app and library are one filter.
namespace mrpt_ext::test_key_defaults
{
namespace
{
LocalizationConfig emptyConfig(const std::string& text = "")
{
  const LandmarkTable map({{.id = 1, .position = {0, -1, 0}}, {.id = 2, .position = {6, 4, 0}}});
  return localizationConfig(Settings::parse(text, "/a/b.ini", localizationKeys()), map);
}

Scenario emptyScenario()
{
  return readScenario(Settings::parse("[Map]\nlandmarks = 1 2 3\n[Path]\nwaypoints = 0 0 1 1\n[Sensor_a]\n", "my.ini",
                                      simulatorKeys()));
}
}  // namespace

TEST(KeyDefaults, OfTheFilterAreThoseOfItsOptions)
{
  const ParticleFilterOptions read = emptyConfig().filter, plain;
  EXPECT_EQ(read.particles, plain.particles);
  EXPECT_EQ(read.initial_particles, plain.initial_particles);
  EXPECT_EQ(read.initial_mode, plain.initial_mode);
  EXPECT_EQ(read.resampling, plain.resampling);
  EXPECT_EQ(read.resample_below, plain.resample_below);
  EXPECT_EQ(read.adaptive_size, plain.adaptive_size);
  EXPECT_EQ(read.kld.bin_xy, plain.kld.bin_xy);
  EXPECT_EQ(read.kld.bin_phi, plain.kld.bin_phi);
  EXPECT_EQ(read.kld.delta, plain.kld.delta);
  EXPECT_EQ(read.kld.epsilon, plain.kld.epsilon);
  EXPECT_EQ(read.kld.min_size, plain.kld.min_size);
  EXPECT_EQ(read.kld.max_size, plain.kld.max_size);
  EXPECT_EQ(read.modes.cell_xy, plain.modes.cell_xy);
  EXPECT_EQ(read.modes.cell_phi, plain.modes.cell_phi);
  EXPECT_EQ(read.learn_reliability, plain.learn_reliability);
  EXPECT_EQ(read.reliability_prior_strength, plain.reliability_prior_strength);
}

TEST(KeyDefaults, OfLiveRunsAreThoseOfTheOnlineLocalizer)
{
  const LocalizationConfig read = emptyConfig(), plain;
  EXPECT_EQ(read.lateness, plain.lateness);
  EXPECT_EQ(read.odometry_wait, plain.odometry_wait);
  EXPECT_EQ(read.step_budget_ms, plain.step_budget_ms);
}

TEST(KeyDefaults, OfRecoveryAndVerdictAreThoseOfTheirOptions)
{
  const ParticleFilterOptions read = emptyConfig().filter, plain;
  EXPECT_EQ(read.recovery.reseed_inlier_ratio, plain.recovery.reseed_inlier_ratio);
  EXPECT_EQ(read.recovery.lost_inlier_ratio, plain.recovery.lost_inlier_ratio);
  EXPECT_EQ(read.recovery.injected_particle_share, plain.recovery.injected_particle_share);
  EXPECT_EQ(read.recovery.relocalization_prior, plain.recovery.relocalization_prior);
  EXPECT_EQ(read.mode_kalman_filters, plain.mode_kalman_filters);
  EXPECT_EQ(read.kalman_proposal_below_ess, plain.kalman_proposal_below_ess);
  EXPECT_EQ(read.verdict.min_best_weight, plain.verdict.min_best_weight);
  EXPECT_EQ(read.verdict.max_std_xy, plain.verdict.max_std_xy);
  EXPECT_EQ(read.verdict.max_std_phi, plain.verdict.max_std_phi);
}

TEST(KeyDefaults, OfTheMotionModelAreThoseOfItsStruct)
{
  const LocalizationConfig config = emptyConfig();
  const MotionModel read = config.filter.motion, plain;
  EXPECT_EQ(read.type, plain.type);
  EXPECT_EQ(read.std_xy_per_m, plain.std_xy_per_m);
  EXPECT_EQ(read.std_phi_per_deg, plain.std_phi_per_deg);
  EXPECT_EQ(read.std_phi_per_m, plain.std_phi_per_m);
  EXPECT_EQ(read.std_xy_per_s, plain.std_xy_per_s);
  EXPECT_EQ(read.std_phi_per_s, plain.std_phi_per_s);
  const OdometryCorrection odometry = config.frames.odometry, none;
  EXPECT_EQ(odometry.scale, none.scale);
  EXPECT_EQ(odometry.distance_per_turn, none.distance_per_turn);
  EXPECT_EQ(odometry.rotation_scale, none.rotation_scale);
  EXPECT_EQ(odometry.pivot_scale, none.pivot_scale);
  EXPECT_EQ(odometry.yaw, none.yaw);
  EXPECT_EQ(odometry.turn_per_m, none.turn_per_m);
  EXPECT_EQ(odometry.turn_per_s, none.turn_per_s);
  EXPECT_EQ(odometry.delay, none.delay);
}

TEST(KeyDefaults, OfARunAreThoseOfItsConfig)
{
  const LocalizationConfig read = emptyConfig(), plain;
  EXPECT_EQ(read.seed, plain.seed);
  EXPECT_EQ(read.repetitions, plain.repetitions);
  EXPECT_EQ(read.engine, plain.engine);
  EXPECT_EQ(read.mrpt_algorithm, plain.mrpt_algorithm);
  EXPECT_EQ(read.frames.window, plain.frames.window);
  EXPECT_EQ(read.frames.independent, plain.frames.independent);
  EXPECT_EQ(read.auto_calibrate, plain.auto_calibrate);
  EXPECT_EQ(read.join_window, plain.join_window);
  EXPECT_EQ(read.seed_window, plain.seed_window);
  EXPECT_EQ(read.methods, plain.methods);
  EXPECT_EQ(read.running_fix.heading_source, plain.running_fix.heading_source);
  EXPECT_EQ(read.limits.within_m, plain.limits.within_m);
  EXPECT_EQ(read.limits.within_deg, plain.limits.within_deg);
  EXPECT_EQ(read.limits.max_convergence_s, plain.limits.max_convergence_s);
  EXPECT_EQ(read.final_scene, plain.final_scene);
  EXPECT_EQ(read.scene_every, plain.scene_every);
  EXPECT_EQ(read.max_detections, plain.max_detections);
  EXPECT_EQ(read.max_landmarks, plain.max_landmarks);
}

TEST(KeyDefaults, OfASensorAreThoseOfItsConfig)
{
  const SensorConfig read = emptyConfig("[Sensor_a]\n").frames.sensors.at("a"), plain;
  EXPECT_EQ(read.delay, plain.delay);
  EXPECT_EQ(read.sweep.duration, plain.sweep.duration);
  EXPECT_EQ(read.sweep.direction, plain.sweep.direction);
  EXPECT_EQ(read.sweep.start, plain.sweep.start);
  EXPECT_EQ(read.std_bearing, plain.std_bearing);
  EXPECT_EQ(read.std_range, plain.std_range);
  EXPECT_EQ(read.std_range_per_m, plain.std_range_per_m);
  EXPECT_EQ(read.std_heading, plain.std_heading);
  EXPECT_EQ(read.bias_bearing, plain.bias_bearing);
  EXPECT_EQ(read.scale_bearing, plain.scale_bearing);
  EXPECT_EQ(read.bias_range, plain.bias_range);
  EXPECT_EQ(read.scale_range, plain.scale_range);
  EXPECT_EQ(read.landmark_bias_range, plain.landmark_bias_range);
  EXPECT_EQ(read.range_along_axis, plain.range_along_axis);
  EXPECT_EQ(read.range_axis, plain.range_axis);
  EXPECT_EQ(read.field_of_view, plain.field_of_view);
  EXPECT_EQ(read.max_range, plain.max_range);
  EXPECT_EQ(read.clutter_probability, plain.clutter_probability);
  EXPECT_EQ(read.detection_probability, plain.detection_probability);
  EXPECT_EQ(read.lever_arm, plain.lever_arm);
  EXPECT_EQ(read.lever_arm_std, plain.lever_arm_std);
  EXPECT_EQ(read.delay_std, plain.delay_std);
  EXPECT_EQ(read.yaw_std, plain.yaw_std);
  EXPECT_EQ(read.association, plain.association);
  EXPECT_EQ(read.reflectors.has_value(), plain.reflectors.has_value());
  EXPECT_EQ(read.ignore, plain.ignore);
}

TEST(KeyDefaults, OfReflectorsAreThoseOfTheirOptions)
{
  const SensorConfig read =
      emptyConfig("[Sensor_a]\nextract = reflectors\nintensity_above = 7\n").frames.sensors.at("a");
  const ReflectorOptions plain;
  ASSERT_TRUE(read.reflectors);
  EXPECT_EQ(read.reflectors->intensity_above, 7);
  EXPECT_EQ(read.reflectors->diameter, plain.diameter);
  EXPECT_EQ(read.reflectors->shape, plain.shape);
}

TEST(KeyDefaults, OfAScenarioAreThoseOfItsStruct)
{
  const Scenario read = emptyScenario(), plain;
  EXPECT_EQ(read.start_time, plain.start_time);
  EXPECT_EQ(read.duration, plain.duration);
  EXPECT_EQ(read.truth_rate_hz, plain.truth_rate_hz);
  EXPECT_EQ(read.random_seed, plain.random_seed);
  EXPECT_EQ(read.map.count, plain.map.count);
  EXPECT_EQ(read.map.columns, plain.map.columns);
  EXPECT_EQ(read.map.rows, plain.map.rows);
  EXPECT_EQ(read.map.low, plain.map.low);
  EXPECT_EQ(read.map.high, plain.map.high);
  EXPECT_EQ(read.map.min_distance, plain.map.min_distance);
  EXPECT_EQ(read.map.with_ids, plain.map.with_ids);
  EXPECT_EQ(read.path.kind, plain.path.kind);
  EXPECT_EQ(read.path.speed, plain.path.speed);
  EXPECT_EQ(read.path.turn_rate, plain.path.turn_rate);
  EXPECT_EQ(read.path.closed, plain.path.closed);
  EXPECT_EQ(read.path.turn_radius, plain.path.turn_radius);
  EXPECT_EQ(read.path.radius, plain.path.radius);
  EXPECT_EQ(read.path.side, plain.path.side);
  EXPECT_EQ(read.path.clockwise, plain.path.clockwise);
  EXPECT_EQ(read.odometry.rate_hz, plain.odometry.rate_hz);
  EXPECT_EQ(read.odometry.std_xy_per_m, plain.odometry.std_xy_per_m);
  EXPECT_EQ(read.odometry.std_phi_deg_per_deg, plain.odometry.std_phi_deg_per_deg);
  EXPECT_EQ(read.odometry.std_phi_deg_per_m, plain.odometry.std_phi_deg_per_m);
}

TEST(KeyDefaults, OfASimulatedSensorAreThoseOfItsStruct)
{
  const SimulatedSensor read = emptyScenario().sensors.at(0), plain;
  EXPECT_EQ(read.kind, plain.kind);
  EXPECT_EQ(read.rate_hz, plain.rate_hz);
  EXPECT_EQ(read.field_of_view, plain.field_of_view);
  EXPECT_EQ(read.max_range, plain.max_range);
  EXPECT_EQ(read.min_range, plain.min_range);
  EXPECT_EQ(read.std_bearing, plain.std_bearing);
  EXPECT_EQ(read.std_range, plain.std_range);
  EXPECT_EQ(read.std_range_per_m, plain.std_range_per_m);
  EXPECT_EQ(read.scale_range, plain.scale_range);
  EXPECT_EQ(read.std_heading, plain.std_heading);
  EXPECT_EQ(read.identity, plain.identity);
  EXPECT_EQ(read.detection_probability, plain.detection_probability);
  EXPECT_EQ(read.clutter_per_reading, plain.clutter_per_reading);
  EXPECT_EQ(read.sees_objects, plain.sees_objects);
  EXPECT_EQ(read.fix_distance, plain.fix_distance);
  EXPECT_EQ(read.fix_bearing, plain.fix_bearing);
}
}  // namespace mrpt_ext::test_key_defaults
