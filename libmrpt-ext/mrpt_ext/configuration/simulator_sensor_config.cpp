#include "mrpt_ext/configuration/localization_choices.h"
#include "mrpt_ext/configuration/simulator_choices.h"
#include "mrpt_ext/configuration/simulator_config.h"

namespace mrpt_ext
{
namespace
{
void readErrors(const Settings& settings, const std::string& section, SimulatedSensor& sensor)
{
  sensor.std_bearing = settings.radians(section, "std_bearing_deg");
  sensor.bias_bearing = settings.radians(section, "bias_bearing_deg");
  sensor.std_range = settings.number(section, "std_range_m");
  sensor.std_range_per_m = settings.number(section, "std_range_per_m");
  sensor.bias_range = settings.number(section, "bias_range_m");
  sensor.scale_range = settings.number(section, "scale_range");
  sensor.baseline_focal = settings.optionalNumber(section, "baseline_focal_m_px").value_or(0);
  sensor.std_disparity = settings.number(section, "std_disparity_px");
  sensor.std_heading = settings.radians(section, "std_heading_deg");
  sensor.bias_heading = settings.radians(section, "bias_heading_deg");
}

void readDetection(const Settings& settings, const std::string& section, SimulatedSensor& sensor)
{
  sensor.identity = settings.choice(section, "identity", identityLevels());
  sensor.wrong_identity_probability = settings.number(section, "wrong_identity_probability");
  sensor.detection_probability = settings.number(section, "detection_probability");
  sensor.clutter_per_reading = settings.number(section, "clutter_per_reading");
  if (settings.hasValue(section, "max_detections"))
    sensor.max_detections = static_cast<int>(settings.integer(section, "max_detections"));
  sensor.sees_objects = settings.flag(section, "sees_objects");
  sensor.fix_distance = settings.number(section, "fix_distance_m");
  sensor.fix_bearing = settings.flag(section, "fix_bearing");
}

void checkSensor(const Settings& settings, const std::string& section, const SimulatedSensor& sensor)
{
  const bool ranging = sensor.kind != SensorKind::bearings && sensor.kind != SensorKind::compass;
  if (ranging && sensor.std_disparity > 0 && !(sensor.baseline_focal > 0))
    throw settings.errorAt(section, "std_disparity_px", "expected baseline_focal_m_px with it");
  if (ranging && sensor.clutter_per_reading > 0 && !sensor.max_range)
    throw settings.errorAt(section, "clutter_per_reading", "expected max_range_m with it, false ranges need a limit");
  if (sensor.max_range && *sensor.max_range <= sensor.min_range)
    throw settings.errorAt(section, "max_range_m", "expected more than min_range_m");
}
}  // namespace

SimulatedSensor readSimulatedSensor(const Settings& settings, const std::string& section)
{
  SimulatedSensor sensor;
  sensor.label = section.substr(section.find('_') + 1);
  sensor.kind = settings.choice(section, "kind", sensorKinds());
  sensor.rate_hz = settings.number(section, "rate_hz");
  sensor.phase_s = settings.number(section, "phase_s");
  sensor.delay_s = settings.number(section, "delay_s");
  sensor.sweep.duration = settings.number(section, "scan_duration_s");
  sensor.sweep.direction = settings.choice(section, "scan_direction", sweepDirections());
  const std::vector<double> pose = settings.numbers(section, "pose");
  if (pose.size() != 4) throw settings.errorAt(section, "pose", "expected 4 numbers, x y z yaw_deg");
  sensor.T_robot_sensor = {pose[0], pose[1], wrap(degToRad(pose[3]))};
  sensor.height = pose[2];
  sensor.horizontal_range = settings.flag(section, "horizontal_range");
  sensor.field_of_view = settings.radians(section, "field_of_view_deg");
  sensor.max_range = settings.optionalNumber(section, "max_range_m");
  sensor.min_range = settings.number(section, "min_range_m");
  readErrors(settings, section, sensor);
  readDetection(settings, section, sensor);
  checkSensor(settings, section, sensor);
  return sensor;
}
}  // namespace mrpt_ext
