#include "mrpt_ext/configuration/sensor_sections.h"

#include <sstream>

#include "mrpt_ext/configuration/localization_choices.h"
#include "mrpt_ext/files/number_format.h"

namespace mrpt_ext
{
namespace
{
const std::string kPrefix = "Sensor_";

/// What to extract from laser scans; nothing where nothing is asked for.
std::optional<ReflectorOptions> reflectorOptions(const Settings& settings, const std::string& section)
{
  if (settings.choice(section, "extract") == "none") return std::nullopt;
  const auto least = settings.optionalNumber(section, "intensity_above");
  if (!least)
    throw settings.errorAt(section, "extract", "reflectors needs the intensity that they exceed, set intensity_above");
  return ReflectorOptions{.intensity_above = *least,
                          .diameter = settings.number(section, "reflector_diameter_m"),
                          .shape = settings.choice(section, "reflector_shape", reflectorShapes())};
}
}  // namespace

LandmarkValues landmarkValues(const Settings& settings, const std::string& section, const std::string& key)
{
  LandmarkValues values;
  if (!settings.hasValue(section, key)) return values;
  std::istringstream words(settings.text(section, key));
  for (std::string word; words >> word;)
  {
    const std::size_t colon = word.find(':');
    const auto id = parseInteger(word.substr(0, colon));
    const auto value = colon == std::string::npos ? std::nullopt : parseNumber(word.substr(colon + 1));
    if (!id || !value) throw settings.errorAt(section, key, "expected id:value pairs such as 1:0.12 4:-0.05");
    if (!values.emplace(*id, *value).second)
      throw settings.errorAt(section, key, "landmark " + std::to_string(*id) + " occurs twice, expected it once");
  }
  return values;
}

SensorConfigs sensorConfigs(const Settings& settings)
{
  SensorConfigs configs;
  for (const std::string& section : settings.sectionsMatching(kPrefix))
  {
    SensorConfig& c = configs[section.substr(kPrefix.size())];
    c.delay = settings.number(section, "delay_s");
    c.sweep.duration = settings.number(section, "scan_duration_s");
    c.sweep.direction = settings.choice(section, "scan_direction", sweepDirections());
    c.sweep.start = settings.optionalRadians(section, "scan_start_deg");
    c.std_bearing = settings.optionalRadians(section, "std_bearing_deg");
    c.std_range = settings.optionalNumber(section, "std_range_m");
    c.std_range_per_m = settings.number(section, "std_range_per_m");
    c.std_heading = settings.optionalRadians(section, "std_heading_deg");
    c.bias_bearing = settings.radians(section, "bias_bearing_deg");
    c.scale_bearing = settings.number(section, "scale_bearing");
    c.bias_range = settings.number(section, "bias_range_m");
    c.scale_range = settings.number(section, "scale_range");
    c.landmark_bias_range = landmarkValues(settings, section, "landmark_bias_range_m");
    c.range_along_axis = settings.flag(section, "range_along_axis");
    c.range_axis = settings.radians(section, "range_axis_deg");
    c.field_of_view = settings.optionalRadians(section, "field_of_view_deg");
    c.max_range = settings.optionalNumber(section, "max_range_m");
    c.clutter_probability = settings.number(section, "clutter_probability");
    c.detection_probability = settings.optionalNumber(section, "detection_probability");
    c.lever_arm = {settings.number(section, "lever_arm_x_m"), settings.number(section, "lever_arm_y_m")};
    c.lever_arm_std = settings.optionalNumber(section, "lever_arm_std_m");
    c.yaw_std = settings.optionalRadians(section, "yaw_std_deg");
    c.delay_std = settings.number(section, "delay_std_s");
    c.association = settings.choice(section, "association", identityLevels());
    c.reflectors = reflectorOptions(settings, section);
    c.ignore = settings.flag(section, "ignore");
  }
  return configs;
}
}  // namespace mrpt_ext
