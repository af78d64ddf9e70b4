#include "mrpt_ext/configuration/simulator_keys.h"

#include "mrpt_ext/configuration/simulator_choices.h"
#include "mrpt_ext/settings/key_section.h"

namespace mrpt_ext
{
namespace
{
constexpr ValueRange kLength{1e-6, ranges::kUnbounded};

KeyTable runKeys()
{
  const Scenario scenario;
  return KeySection("Simulation")
      .number("duration_s", "s", scenario.duration, kLength, "Length of the log.")
      .forBeginners()
      .number("start_time_s", "s", scenario.start_time, {1, 1e10}, "Stamp of the first record, seconds since 1970.")
      .number("truth_rate_hz", "Hz", scenario.truth_rate_hz, {0.01, 1000}, "Poses of the ground truth per second.")
      .integer("random_seed", "", scenario.random_seed, {0, 9e18}, "Same seed, same files. --seed replaces it.");
}

KeyTable mapKeys()
{
  const MapPlan map;
  return KeySection("Map")
      .choice("layout", MapSource::written, mapSources(), "Where the landmarks come from.")
      .forBeginners()
      .path("file", "Map CSV id,x,y,z,category for layout = file.")
      .numbers("landmarks", "m", {}, ranges::kAny, "x y z of every landmark, for layout = explicit.")
      .forBeginners()
      .numbers("ids", "", {}, ranges::kAny, "Id of every explicit landmark. Without it they are numbered from 1.")
      .flag("with_ids", map.with_ids, "false: the map has no ids, all landmarks are anonymous.")
      .text("categories", "", "",
            "Names separated by blanks, assigned to the landmarks in turn. Not set: no categories.")
      .integer("count", "", map.count, {1, 1e6}, "Number of landmarks of a random map.")
      .number("min_distance_m", "m", map.min_distance, ranges::kNotNegative,
              "Minimum distance between two random landmarks.")
      .integer("columns", "", map.columns, {1, 1e4}, "Landmarks of a grid along x.")
      .integer("rows", "", map.rows, {1, 1e4}, "Landmarks of a grid along y.")
      .numbers("box", "m", {map.low.x(), map.high.x(), map.low.y(), map.high.y(), map.low.z(), map.high.z()},
               ranges::kAny, "min_x max_x min_y max_y min_z max_z of a random map or grid.");
}

/// How the robot, or an object, drives.
KeySection& addDrive(KeySection& keys)
{
  const PathPlan path;
  return keys.numbers("waypoints", "m", {}, ranges::kAny, "x y of every waypoint.")
      .flag("closed", path.closed, "From the last waypoint back to the first, round and round. false: stop there.")
      .number("speed_m_s", "m/s", path.speed, kLength, "Speed along the path.")
      .number(
          "turn_radius_m", "m", path.turn_radius, ranges::kNotNegative,
          "Radius of rounded corners; 0: turns in place. A closed path with rounded corners begins in the middle of "
          "its first leg.")
      .degrees("turn_rate_deg_s", "deg/s", path.turn_rate, kLength,
               "Turn rate of turns in place. Also the largest one of a random walk.");
}

KeyTable pathKeys()
{
  const PathPlan path;
  KeySection keys("Path");
  keys.choice("type", path.kind, pathKinds(), "How the robot drives.").forBeginners();
  return addDrive(keys)
      .numbers("start", "m m deg", {path.start.x, path.start.y, radToDeg(path.start.phi)}, ranges::kAny,
               "x y heading at the start, for standstill and random_walk.")
      .numbers("centre", "m", {path.centre.x(), path.centre.y()}, ranges::kAny,
               "x y of the centre of circle or square.")
      .number("radius_m", "m", path.radius, kLength, "Radius of the circle.")
      .number("side_m", "m", path.side, kLength, "Side of the square.")
      .flag("clockwise", path.clockwise, "Sense of circle and square.")
      .numbers("bounds", "m", {}, ranges::kAny, "min_x max_x min_y max_y of a random walk.")
      .number("straight_share", "", path.straight_share, {0, 1}, "Share of straight lines in a random walk.")
      .number("rest_share", "", path.rest_share, {0, 1}, "Share of rests in a random walk.");
}

KeyTable odometryKeys()
{
  const OdometryNoise noise;
  return KeySection("Odometry")
      .number("rate_hz", "Hz", noise.rate_hz, {0, 1000}, "Odometry records per second; 0: no odometry.")
      .number("std_xy_per_m", "m", noise.std_xy_per_m, ranges::kNotNegative,
              "Standard deviation of the position after one metre. Along and across; variances add up.")
      .forBeginners()
      .number("std_phi_deg_per_deg", "deg", noise.std_phi_deg_per_deg, ranges::kNotNegative,
              "Standard deviation of the heading after a turn of 1 deg. Variances add up.")
      .number("std_phi_deg_per_m", "deg", noise.std_phi_deg_per_m, ranges::kNotNegative,
              "Standard deviation of the heading after one metre.")
      .forBeginners()
      .number("std_xy_per_sqrt_s", "m", noise.std_xy_per_sqrt_s, ranges::kNotNegative,
              "Standard deviation of the position after one second. Also at standstill.")
      .alias("std_xy_min")
      .number("std_phi_deg_per_sqrt_s", "deg", noise.std_phi_deg_per_sqrt_s, ranges::kNotNegative,
              "Standard deviation of the heading after one second. Also at standstill.")
      .alias("std_phi_min_deg")
      .number("scale_error", "", noise.scale_error, {-0.5, 0.5}, "Measured / true distance - 1.")
      .number("rotation_scale_error", "", noise.rotation_scale_error, {-0.5, 0.5}, "Measured / true turn - 1.")
      .number("arc_scale_error", "", noise.arc_scale_error, {-0.5, 2},
              "Measured / true turn - 1 while driving, in addition. Turns in place are not affected.")
      .degrees("veer_deg_per_m", "deg", noise.veer, ranges::kAny,
               "Turn to the left per metre that odometry does not measure.")
      .degrees("drift_deg_s", "deg/s", noise.drift, ranges::kAny,
               "How fast the heading of odometry drifts, also at standstill.")
      .number("slips_per_minute", "", noise.slips_per_minute, {0, 600}, "Expected number of slips.")
      .number("std_slip_m", "m", noise.std_slip, ranges::kNotNegative,
              "Standard deviation of the displacement that odometry misses in a slip.")
      .degrees("std_slip_deg", "deg", noise.std_slip_heading, ranges::kNotNegative,
               "Standard deviation of the turn that odometry misses in a slip.");
}

KeyTable randomErrorKeys()
{
  const ErrorSpread spread;
  return KeySection("RandomErrors")
      .degrees("drift_deg_s", "deg/s", spread.drift, ranges::kNotNegative,
               "Drift of the heading of odometry, up to this in either direction.")
      .number("arc_turn_loss", "", spread.arc_turn_loss, {0, 0.9},
              "Share by which arcs turn less than measured, up to this.")
      .number("noise_factor", "", spread.noise_factor, {1, 100},
              "Odometry noise is 1 to this many times what [Odometry] states.")
      .number("slips_per_minute", "", spread.slips_per_minute, {0, 600}, "Expected number of slips, up to this.")
      .number("delay_s", "s", spread.delay, ranges::kNotNegative, "Delay of every sensor, up to this.")
      .number("lever_arm_m", "m", spread.lever_arm, ranges::kNotNegative,
              "How far a sensor is from its logged place on the robot, along and across, up to this in either "
              "direction.")
      .number("scale_error", "", spread.distance_scale, {0, 0.5},
              "Measured / true distance - 1, up to this in either direction.")
      .number("rotation_scale_error", "", spread.rotation_scale, {0, 0.5},
              "Measured / true turn - 1, up to this in either direction.")
      .degrees("veer_deg_per_m", "deg", spread.veer, ranges::kNotNegative,
               "Turn per metre that odometry does not measure, up to this in either direction.")
      .degrees("bias_bearing_deg", "deg", spread.bearing_offset, ranges::kNotNegative,
               "Offset of the bearings of every sensor, up to this in either direction.")
      .number("bias_range_m", "m", spread.range_offset, ranges::kNotNegative,
              "Offset of the ranges of every sensor, up to this in either direction.")
      .number("range_scale_error", "", spread.range_scale, {0, 0.5},
              "Measured / true range - 1 of every sensor, up to this in either direction.");
}

KeyTable objectKeys()
{
  KeySection keys("Object_<label>");
  keys.numbers("position", "m", {}, ranges::kAny, "x y z of an object that stands still. With waypoints only z counts.")
      .text("category", "", "", "Category of its detections. Not set: its label.")
      .number("radius_m", "m", SimulatedObject().radius, ranges::kNotNegative,
              "It hides what is behind it. 0: it hides nothing.");
  return addDrive(keys);
}

KeyTable barrierKeys()
{
  const BarrierPlan plan;
  return KeySection("Barriers")
      .integer("count", "", plan.count, {0, 1e4},
               "Rows of posts at random places that look like landmarks and hide what is behind them.")
      .number("length_m", "m", plan.length, ranges::kNotNegative, "Length of a row.")
      .number("spacing_m", "m", plan.spacing, kLength, "Distance between neighbouring posts.")
      .number("post_radius_m", "m", plan.post_radius, ranges::kNotNegative, "Radius of a post.")
      .number("clearance_m", "m", plan.clearance, ranges::kNotNegative, "Least distance of a post to the path.");
}

KeyTable kidnappingKeys()
{
  return KeySection("Kidnapping_<label>")
      .number("time_s", "s", kUnset, ranges::kNotNegative, "When the robot is displaced, seconds after the start.")
      .numbers("pose", "m m deg", {}, ranges::kAny, "x y heading where it is put down. Its odometry does not notice.");
}
}  // namespace

KeyTable simulatorKeys()
{
  KeyTable table = runKeys();
  return table.append(mapKeys())
      .append(pathKeys())
      .append(odometryKeys())
      .append(randomErrorKeys())
      .append(simulatedSensorKeys())
      .append(objectKeys())
      .append(barrierKeys())
      .append(kidnappingKeys());
}
}  // namespace mrpt_ext
