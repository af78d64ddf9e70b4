#include "mrpt_ext/configuration/simulator_keys.h"

namespace mrpt_ext
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr ValueRange kNotNegative{0, kInfinity};
constexpr const char* kSection = "Sensor_<label>";

KeySpec number(const char* name, const char* unit, const char* default_value, ValueRange range, const char* help)
{
  return {kSection, name, KeyType::number, unit, default_value, range, {}, help};
}

KeySpec flag(const char* name, const char* default_value, const char* help)
{
  return {kSection, name, KeyType::flag, "", default_value, {}, {}, help};
}

std::vector<KeySpec> viewKeys()
{
  return {
      {kSection,
       "kind",
       KeyType::choice,
       "",
       "bearings",
       {},
       {{"bearings", {}}, {"ranges", {}}, {"range_bearing", {}}, {"running_fix", {}}, {"compass", {}}},
       "What it measures. running_fix: the range of one landmark, and again after the robot has moved on."},
      number("rate_hz", "Hz", "5", {1e-3, 1000}, "Readings per second."),
      number("phase_s", "s", "0", kNotNegative, "Time of the first reading after the start."),
      number("delay_s", "s", "0", {-10, 10}, "How old a reading is at its stamp: stamps are this much late."),
      {kSection,
       "pose",
       KeyType::numbers,
       "m m m deg",
       "0 0 0 0",
       {},
       {},
       "x y z yaw on the robot (x forward, y left); yaw turns the forward axis of the sensor."},
      flag("horizontal_range", "false", "Ranges are measured in the floor plane, not as a slant."),
      number("field_of_view_deg", "deg", "360", {1e-3, 360}, "Full angle around the forward axis."),
      number("max_range_m", "m", "", {1e-3, kInfinity}, "Farthest landmark seen, horizontally. Not set: no limit."),
      number("min_range_m", "m", "0", kNotNegative, "Nearest landmark seen, horizontally."),
  };
}

std::vector<KeySpec> errorKeys()
{
  return {
      number("std_bearing_deg", "deg", "1", kNotNegative, "Standard deviation of bearings."),
      number("bias_bearing_deg", "deg", "0", {-180, 180}, "Added to every bearing."),
      number("std_range_m", "m", "0", kNotNegative,
             "Standard deviation of ranges, the part that is the same everywhere."),
      number("std_range_per_m", "m/m", "0", kNotNegative, "The part that grows with the range; the variances add up."),
      number("bias_range_m", "m", "0", {}, "Added to every range."),
      number("scale_range", "", "1", {0.1, 10}, "Every range is multiplied by this before the bias is added."),
      number("baseline_focal_m_px", "m px", "", {1e-9, kInfinity}, "Baseline times focal length of a stereo pair."),
      number("std_disparity_px", "px", "0", kNotNegative,
             "Standard deviation of a stereo pair's disparity; the range error then grows with the range squared."),
      number("std_heading_deg", "deg", "5", kNotNegative, "Standard deviation of a compass."),
      number("bias_heading_deg", "deg", "0", {-180, 180}, "Added to every heading of a compass."),
  };
}

std::vector<KeySpec> detectionKeys()
{
  return {
      {kSection,
       "identity",
       KeyType::choice,
       "",
       "known",
       {},
       {{"known", {}}, {"category", {}}, {"anonymous", {}}},
       "What a detection tells about its landmark: id and category, category only, or nothing."},
      number("wrong_identity_probability", "", "0", {0, 1},
             "Share of landmarks reported under the name of another one."),
      number("detection_probability", "", "1", {0, 1}, "Share of landmarks in view that are detected."),
      number("clutter_per_reading", "", "0", {0, 1000},
             "Expected number of detections of nothing, anywhere in view, under the name of any landmark."),
      {kSection,
       "max_detections",
       KeyType::integer,
       "",
       "",
       {1, 1e6},
       {},
       "A random choice of this many is reported when more are seen. Not set: all."},
      flag("sees_objects", "true", "Whether it detects the things of [Object_<label>], too."),
      number("fix_distance_m", "m", "0.1", {1e-3, kInfinity}, "Way between the two ranges of a running fix."),
      flag("fix_bearing", "false", "The second range of a running fix comes with a bearing."),
  };
}
}  // namespace

KeyTable simulatedSensorKeys()
{
  KeyTable table(viewKeys());
  return table.append(errorKeys()).append(detectionKeys());
}
}  // namespace mrpt_ext
