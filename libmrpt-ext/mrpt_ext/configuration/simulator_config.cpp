#include "mrpt_ext/configuration/simulator_config.h"

#include <algorithm>

#include "mrpt_ext/configuration/simulator_choices.h"
#include "mrpt_ext/files/landmark_map_file.h"

namespace mrpt_ext
{
namespace
{
/// A list of numbers that must come in groups of `group`, e.g. x y z of every landmark.
std::vector<double> groupsOf(std::size_t group, const Settings& settings, const std::string& section, const char* key)
{
  const std::vector<double> values = settings.numbers(section, key);
  if (values.size() % group == 0) return values;
  throw settings.errorAt(section, key, "expected groups of " + std::to_string(group) + " numbers");
}

std::vector<double> exactly(std::size_t count, const Settings& settings, const std::string& section, const char* key)
{
  const std::vector<double> values = settings.numbers(section, key);
  if (values.size() == count) return values;
  throw settings.errorAt(section, key, "expected " + std::to_string(count) + " numbers");
}

/// "x y phi_deg".
Pose2 poseFrom(const Settings& settings, const std::string& section, const char* key)
{
  const std::vector<double> v = exactly(3, settings, section, key);
  return {v[0], v[1], wrap(degToRad(v[2]))};
}

std::string labelOf(const std::string& section) { return section.substr(section.find('_') + 1); }

std::vector<Landmark> explicitLandmarks(const Settings& settings, const MapPlan& plan)
{
  const std::vector<double> xyz = groupsOf(3, settings, "Map", "landmarks");
  const std::size_t count = xyz.size() / 3;
  std::vector<Landmark> landmarks(count);
  std::vector<double> ids(count);
  for (std::size_t i = 0; i < count; ++i) ids[i] = static_cast<double>(i + 1);
  if (settings.isSet("Map", "ids")) ids = exactly(count, settings, "Map", "ids");
  for (std::size_t i = 0; i < count; ++i)
  {
    landmarks[i].position = {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
    if (plan.with_ids) landmarks[i].id = static_cast<int>(ids[i]);
    if (ids[i] != static_cast<int>(ids[i]) || ids[i] < 0)
      throw settings.errorAt("Map", "ids", "expected whole numbers of at least 0");
    if (!plan.categories.empty()) landmarks[i].category = plan.categories[i % plan.categories.size()];
  }
  return landmarks;
}

MapPlan readMap(const Settings& settings)
{
  MapPlan plan;
  plan.with_ids = settings.flag("Map", "with_ids");
  plan.categories = settings.words("Map", "categories");
  const MapSource source = settings.choice("Map", "layout", mapSources());
  if (source == MapSource::written) plan.landmarks = explicitLandmarks(settings, plan);
  if (source == MapSource::file) plan.landmarks = readLandmarkMapFile(settings.existingPath("Map", "file")).all();
  if (source == MapSource::random) plan.layout = MapLayout::random;
  if (source == MapSource::grid) plan.layout = MapLayout::grid;
  plan.count = static_cast<int>(settings.integer("Map", "count"));
  plan.columns = static_cast<int>(settings.integer("Map", "columns"));
  plan.rows = static_cast<int>(settings.integer("Map", "rows"));
  plan.min_distance = settings.number("Map", "min_distance_m");
  const std::vector<double> box = exactly(6, settings, "Map", "box");
  for (int axis = 0; axis < 3; ++axis)
  {
    plan.low[axis] = box[2 * axis];
    plan.high[axis] = box[2 * axis + 1];
  }
  if ((plan.low.array() > plan.high.array()).any())
    throw settings.errorAt("Map", "box", "expected every min to be at most its max");
  return plan;
}

/// The keys that the robot's path and an object's path have in common.
void readDrive(const Settings& settings, const std::string& section, PathPlan& plan)
{
  plan.speed = settings.number(section, "speed_m_s");
  plan.turn_radius = settings.number(section, "turn_radius_m");
  plan.turn_rate = settings.radians(section, "turn_rate_deg_s");
  plan.closed = settings.flag(section, "closed");
  if (plan.kind != PathKind::waypoints) return;
  const std::vector<double> xy = groupsOf(2, settings, section, "waypoints");
  for (std::size_t i = 0; i < xy.size(); i += 2) plan.waypoints.emplace_back(xy[i], xy[i + 1]);
}

PathPlan readPath(const Settings& settings)
{
  PathPlan plan;
  plan.kind = settings.choice("Path", "type", pathKinds());
  readDrive(settings, "Path", plan);
  plan.start = poseFrom(settings, "Path", "start");
  const std::vector<double> centre = exactly(2, settings, "Path", "centre");
  plan.centre = {centre[0], centre[1]};
  plan.radius = settings.number("Path", "radius_m");
  plan.side = settings.number("Path", "side_m");
  plan.clockwise = settings.flag("Path", "clockwise");
  if (plan.kind != PathKind::random_walk) return plan;
  plan.straight_share = settings.number("Path", "straight_share");
  plan.rest_share = settings.number("Path", "rest_share");
  const std::vector<double> bounds = exactly(4, settings, "Path", "bounds");
  plan.low = {bounds[0], bounds[2]};
  plan.high = {bounds[1], bounds[3]};
  return plan;
}

OdometryNoise readOdometry(const Settings& settings)
{
  const auto value = [&](const char* key) { return settings.number("Odometry", key); };
  OdometryNoise noise;
  noise.rate_hz = value("rate_hz");
  noise.std_xy_per_m = value("std_xy_per_m");
  noise.std_phi_deg_per_deg = value("std_phi_deg_per_deg");
  noise.std_phi_deg_per_m = value("std_phi_deg_per_m");
  noise.std_xy_per_sqrt_s = value("std_xy_per_sqrt_s");
  noise.std_phi_deg_per_sqrt_s = value("std_phi_deg_per_sqrt_s");
  noise.scale_error = value("scale_error");
  noise.rotation_scale_error = value("rotation_scale_error");
  noise.arc_scale_error = value("arc_scale_error");
  noise.veer = settings.radians("Odometry", "veer_deg_per_m");
  noise.drift = settings.radians("Odometry", "drift_deg_s");
  noise.slips_per_minute = value("slips_per_minute");
  noise.std_slip = value("std_slip_m");
  noise.std_slip_heading = settings.radians("Odometry", "std_slip_deg");
  return noise;
}

ErrorSpread readRandomErrors(const Settings& settings)
{
  const auto value = [&](const char* key) { return settings.number("RandomErrors", key); };
  return {.drift = settings.radians("RandomErrors", "drift_deg_s"),
          .arc_turn_loss = value("arc_turn_loss"),
          .noise_factor = value("noise_factor"),
          .slips_per_minute = value("slips_per_minute"),
          .delay = value("delay_s"),
          .lever_arm = value("lever_arm_m"),
          .distance_scale = value("scale_error"),
          .rotation_scale = value("rotation_scale_error"),
          .veer = settings.radians("RandomErrors", "veer_deg_per_m"),
          .bearing_offset = settings.radians("RandomErrors", "bias_bearing_deg"),
          .range_offset = value("bias_range_m"),
          .range_scale = value("range_scale_error")};
}

SimulatedObject readObject(const Settings& settings, const std::string& section)
{
  SimulatedObject object;
  object.category = settings.hasValue(section, "category") ? settings.text(section, "category") : labelOf(section);
  object.path.kind = settings.hasValue(section, "waypoints") ? PathKind::waypoints : PathKind::standstill;
  object.radius = settings.number(section, "radius_m");
  readDrive(settings, section, object.path);
  if (!settings.hasValue(section, "position") && settings.hasValue(section, "waypoints")) return object;
  const std::vector<double> position = exactly(3, settings, section, "position");
  object.path.start = {position[0], position[1], 0};
  object.z = position[2];
  return object;
}

BarrierPlan readBarriers(const Settings& settings)
{
  return {.count = static_cast<int>(settings.integer("Barriers", "count")),
          .length = settings.number("Barriers", "length_m"),
          .spacing = settings.number("Barriers", "spacing_m"),
          .post_radius = settings.number("Barriers", "post_radius_m"),
          .clearance = settings.number("Barriers", "clearance_m")};
}
}  // namespace

Scenario readScenario(const Settings& settings)
{
  Scenario scenario;
  scenario.duration = settings.number("Simulation", "duration_s");
  scenario.start_time = settings.number("Simulation", "start_time_s");
  scenario.truth_rate_hz = settings.number("Simulation", "truth_rate_hz");
  scenario.random_seed = static_cast<std::uint64_t>(settings.integer("Simulation", "random_seed"));
  scenario.map = readMap(settings);
  scenario.path = readPath(settings);
  scenario.odometry = readOdometry(settings);
  scenario.spread = readRandomErrors(settings);
  for (const std::string& section : settings.sectionsMatching("Sensor_"))
  {
    scenario.sensors.push_back(readSimulatedSensor(settings, section));
    if (scenario.sensors.back().kind == SensorKind::running_fix && !(scenario.odometry.rate_hz > 0))
      throw settings.errorAt(section, "kind", "a running fix needs odometry, expected [Odometry] rate_hz above 0");
  }
  for (const std::string& section : settings.sectionsMatching("Object_"))
    scenario.objects.push_back(readObject(settings, section));
  scenario.barriers = readBarriers(settings);
  for (const std::string& section : settings.sectionsMatching("Kidnapping_"))
    scenario.kidnappings.push_back({settings.number(section, "time_s"), poseFrom(settings, section, "pose")});
  std::sort(scenario.kidnappings.begin(), scenario.kidnappings.end(),
            [](const Kidnapping& a, const Kidnapping& b) { return a.time < b.time; });
  return scenario;
}
}  // namespace mrpt_ext
