#include "mrpt_ext/configuration/simulator_keys.h"

namespace mrpt_ext
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr ValueRange kNotNegative{0, kInfinity};
constexpr ValueRange kPositive{1e-6, kInfinity};

KeySpec number(const char* section, const char* name, const char* unit, const char* default_value, ValueRange range,
               const char* help)
{
  return {section, name, KeyType::number, unit, default_value, range, {}, help};
}

KeySpec numbers(const char* section, const char* name, const char* unit, const char* default_value, const char* help)
{
  return {section, name, KeyType::numbers, unit, default_value, {}, {}, help};
}

KeySpec flag(const char* section, const char* name, const char* default_value, const char* help)
{
  return {section, name, KeyType::flag, "", default_value, {}, {}, help};
}

KeySpec integer(const char* section, const char* name, const char* default_value, ValueRange range, const char* help)
{
  return {section, name, KeyType::integer, "", default_value, range, {}, help};
}

std::vector<KeySpec> runKeys()
{
  const char* const s = "Simulation";
  return {
      number(s, "duration_s", "s", "60", kPositive, "Length of the log."),
      number(s, "start_time_s", "s", "1000", {1, 1e10}, "Stamp of the first record, seconds since 1970."),
      number(s, "truth_rate_hz", "Hz", "10", {0.01, 1000}, "Rows per second of the ground truth."),
      integer(s, "random_seed", "1", {0, 9e18}, "Same seed, same files. --seed wins over it."),
  };
}

std::vector<KeySpec> mapKeys()
{
  const char* const s = "Map";
  return {
      {s,
       "layout",
       KeyType::choice,
       "",
       "explicit",
       {},
       {{"explicit", {}}, {"file", {}}, {"random", {}}, {"grid", {}}},
       "Where the landmarks come from: the keys landmarks, ids and categories; a map CSV; drawn at random in a box; or "
       "rows and columns over a box."},
      {s, "file", KeyType::path, "", "", {}, {}, "Map CSV for layout = file: id,x,y,z,category."},
      numbers(s, "landmarks", "m", "", "x y z of every landmark, for layout = explicit."),
      numbers(s, "ids", "", "", "Id of every explicit landmark; without it they are numbered from 1."),
      flag(s, "with_ids", "true", "false: the map names no ids, all landmarks are anonymous."),
      {s,
       "categories",
       KeyType::text,
       "",
       "",
       {},
       {},
       "Names separated by blanks, given to the landmarks in turn. Not set: no categories."},
      integer(s, "count", "10", {1, 1e6}, "Number of landmarks of a random map."),
      number(s, "min_distance_m", "m", "0", kNotNegative, "Smallest distance between two random landmarks."),
      integer(s, "columns", "4", {1, 1e4}, "Landmarks of a grid along x."),
      integer(s, "rows", "3", {1, 1e4}, "Landmarks of a grid along y."),
      numbers(s, "box", "m", "0 10 0 10 0 0", "min_x max_x min_y max_y min_z max_z of a random map or grid."),
  };
}

/// How the robot, or an object, drives.
std::vector<KeySpec> driveKeys(const char* section)
{
  return {
      numbers(section, "waypoints", "m", "", "x y of every waypoint."),
      flag(section, "closed", "true", "Go on from the last waypoint to the first, round and round; else stop there."),
      number(section, "speed_m_s", "m/s", "0.3", kPositive, "Speed along the way."),
      number(section, "turn_radius_m", "m", "0", kNotNegative,
             "Radius of rounded corners; 0: the robot turns in place at waypoints. A closed way with rounded corners "
             "begins in the middle of its first leg."),
      number(section, "turn_rate_deg_s", "deg/s", "60", kPositive,
             "Turn rate at waypoints without radius; the largest one of a random walk."),
  };
}

std::vector<KeySpec> pathKeys()
{
  const char* const s = "Path";
  std::vector<KeySpec> keys{
      {s,
       "type",
       KeyType::choice,
       "",
       "waypoints",
       {},
       {{"waypoints", {}}, {"circle", {}}, {"square", {}}, {"random_walk", {}}, {"standstill", {}}},
       "How the robot drives."}};
  for (KeySpec& key : driveKeys(s)) keys.push_back(std::move(key));
  const std::vector<KeySpec> more{
      numbers(s, "start", "m m deg", "0 0 0", "x y heading at the start, for standstill and random_walk."),
      numbers(s, "centre", "m", "0 0", "x y of the middle of circle or square."),
      number(s, "radius_m", "m", "1", kPositive, "Radius of the circle. It starts at its right end."),
      number(s, "side_m", "m", "1", kPositive, "Side of the square."),
      flag(s, "clockwise", "false", "Sense of circle and square."),
      numbers(s, "bounds", "m", "", "min_x max_x min_y max_y of a random walk."),
  };
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

std::vector<KeySpec> odometryKeys()
{
  const char* const s = "Odometry";
  return {
      number(s, "rate_hz", "Hz", "10", {0, 1000}, "Odometry records per second; 0: the robot has no odometry."),
      number(s, "std_xy_per_m", "m", "0.02", kNotNegative,
             "Standard deviation of the position after one metre, along and across; grows with the root of the way."),
      number(s, "std_phi_deg_per_deg", "deg", "0.1", kNotNegative,
             "Standard deviation of the heading after turning one degree; grows with the root of the turn."),
      number(s, "std_phi_deg_per_m", "deg", "0.5", kNotNegative, "Standard deviation of the heading after one metre."),
      number(s, "std_xy_min", "m", "0", kNotNegative,
             "Standard deviation of the position after one second, also at standstill."),
      number(s, "std_phi_min_deg", "deg", "0", kNotNegative,
             "Standard deviation of the heading after one second, also at standstill."),
      number(s, "scale_error", "", "0", {-0.5, 0.5}, "Measured way / true way - 1."),
      number(s, "rotation_scale_error", "", "0", {-0.5, 0.5}, "Measured turn / true turn - 1."),
  };
}

std::vector<KeySpec> objectKeys()
{
  const char* const s = "Object_<label>";
  std::vector<KeySpec> keys{
      numbers(s, "position", "m", "", "x y z of a thing that stands still; with waypoints only z counts."),
      {s, "category", KeyType::text, "", "", {}, {}, "What detections call it; not set: its label."}};
  for (KeySpec& key : driveKeys(s)) keys.push_back(std::move(key));
  return keys;
}

std::vector<KeySpec> kidnappingKeys()
{
  const char* const s = "Kidnapping_<label>";
  return {number(s, "time_s", "s", "", kNotNegative, "When the robot is carried away, seconds after the start."),
          numbers(s, "pose", "m m deg", "", "x y heading where it is put down; its odometry notices nothing.")};
}
}  // namespace

KeyTable simulatorKeys()
{
  KeyTable table(runKeys());
  return table.append(mapKeys())
      .append(pathKeys())
      .append(odometryKeys())
      .append(simulatedSensorKeys())
      .append(objectKeys())
      .append(kidnappingKeys());
}
}  // namespace mrpt_ext
