#include "mrpt_ext/frames/sensor_config.h"

#include <algorithm>

#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
const std::string kPrefix = "Sensor_";
constexpr const char* kBelowHeight = "slant range shorter than the height difference";
constexpr double kLeastDepthShare = 0.1;  // beside or behind the sensor the depth does not determine the range

InputError missingStd(const std::string& sensor, const std::string& what, const std::string& key)
{
  return configurationError("sensor '" + sensor + "' logs " + what + " without a standard deviation, set [" + kPrefix +
                            sensor + "] " + key);
}

SensorModel configured(SensorModel model, const SensorConfig& config)
{
  if (config.field_of_view) model.field_of_view = *config.field_of_view;
  model.has_field_of_view = model.has_field_of_view || config.field_of_view.has_value();
  if (config.max_range) model.max_range = config.max_range;
  model.clutter_probability = config.clutter_probability;
  model.detection_probability = config.detection_probability;
  model.lever_arm_std = config.lever_arm_std;
  model.yaw_std = config.yaw_std.value_or(0);
  model.delay_std = config.delay_std;
  return model;
}

/// Where the sensor is on the robot.
Pose2 configuredPlace(const Pose2& logged, const SensorConfig& config)
{
  return {logged.x + config.lever_arm.x(), logged.y + config.lever_arm.y(), logged.phi};
}

void reduceIdentity(Detection& detection, IdentityLevel association, const LandmarkTable& map)
{
  if (association == IdentityLevel::known) return;
  if (const auto known = map.indexOf(detection.id); known && detection.category.empty())
    detection.category = map[*known].category;
  detection.id = kNoId;
  if (association == IdentityLevel::anonymous) detection.category.clear();
}

/// Measured minus scaled true range, for identified ranges to this landmark.
double rangeBias(const SensorConfig& config, int id)
{
  const bool identified = config.association == IdentityLevel::known && id != kNoId;
  return config.bias_range + (identified ? valueOf(config.landmark_bias_range, id) : 0);
}

/// Corrects a measured range and its standard deviation; `depth_share` of the true range was measured.
void correctRange(double& range, double& std, const SensorConfig& config, const std::string& sensor, int id,
                  double depth_share = 1)
{
  range = (range - rangeBias(config, id)) / (config.scale_range * depth_share);
  if (config.std_range) std = *config.std_range;
  std += config.std_range_per_m * std::max(range, 0.0);
  if (!(std > 0)) throw missingStd(sensor, "ranges", "std_range_m");
}

/// Cosine between the axis and the landmark where ranges are logged as depth along that axis; else 1. `detection`: as
/// logged.
double depthShare(const Detection& detection, const SensorConfig& config)
{
  return config.range_along_axis && detection.bearing ? std::cos(*detection.bearing - config.range_axis) : 1.0;
}

void correctBearing(double& bearing, double& std, const SensorConfig& config, const std::string& sensor)
{
  bearing = wrap(wrap(bearing - config.bias_bearing) / config.scale_bearing);
  if (config.std_bearing) std = *config.std_bearing;
  if (!(std > 0)) throw missingStd(sensor, "bearings", "std_bearing_deg");
}

/// True for a slant range that no horizontal distance explains: of a landmark nearly overhead, by its noise.
template <typename RangeReading>
bool isBelowHeight(double range, int id, const RangeReading& reading, const LandmarkTable& map)
{
  const auto known = map.indexOf(id);
  if (!known || reading.horizontal_range) return false;
  return range < std::abs(map[*known].position.z() - reading.sensor_height);
}
bool isBelowHeight(const Detection& detection, const Reading& reading, const LandmarkTable& map)
{
  return detection.range && isBelowHeight(*detection.range, detection.id, reading, map);
}

/// Why the detection fits no pose; empty when it may fit one.
std::string whyUnusable(const Detection& detection, const Reading& reading, const LandmarkTable& map,
                        IdentityLevel association)
{
  const bool identified = association == IdentityLevel::known && detection.id != kNoId;
  if (identified && !map.indexOf(detection.id)) return "id not in the map";
  if (detection.range && !(*detection.range > 0)) return "range not above zero";
  return isBelowHeight(detection, reading, map) && !detection.bearing ? kBelowHeight : "";
}
std::string whyUnusable(const RunningFixReading& fix, const LandmarkTable& map, IdentityLevel association)
{
  if (association != IdentityLevel::known) return "running fix, not identified";
  if (!map.indexOf(fix.id)) return "id not in the map";
  const double shorter = std::min(fix.first_range, fix.second_range);
  if (!(shorter > 0)) return "range not above zero";
  return isBelowHeight(shorter, fix.id, fix, map) ? kBelowHeight : "";
}
}  // namespace

double valueOf(const LandmarkValues& values, int id)
{
  const auto found = values.find(id);
  return found == values.end() ? 0 : found->second;
}

const SensorConfig& configOf(const SensorConfigs& configs, const std::string& label)
{
  static const SensorConfig kDefaults;
  for (std::string name = label;; name.resize(name.rfind('.')))
  {
    if (const auto found = configs.find(name); found != configs.end()) return found->second;
    if (name.find('.') == std::string::npos) return kDefaults;
  }
}

double loggedBearing(double bearing, const SensorConfig& config)
{
  return wrap(config.scale_bearing * wrap(bearing) + config.bias_bearing);
}

Reading configured(Reading reading, const SensorConfigs& configs, const LandmarkTable& map,
                   UnusableDetections& unusable)
{
  const SensorConfig& config = configOf(configs, reading.sensor);
  reading.time -= config.delay;
  reading.T_robot_sensor = configuredPlace(reading.T_robot_sensor, config);
  reading.model = configured(reading.model, config);
  std::vector<Detection> usable;
  for (Detection& detection : reading.detections)
  {
    const double depth_share = depthShare(detection, config);
    if (detection.bearing) correctBearing(*detection.bearing, detection.std_bearing, config, reading.sensor);
    if (detection.facing) detection.facing = turnedBack(*detection.facing, config.bias_bearing);
    if (detection.range)
      correctRange(*detection.range, detection.std_range, config, reading.sensor, detection.id, depth_share);
    const std::string why = detection.range && depth_share < kLeastDepthShare
                                ? "depth of a landmark that is not ahead"
                                : whyUnusable(detection, reading, map, config.association);
    if (!why.empty())
    {
      ++unusable[reading.sensor + ": " + why];
      continue;
    }
    if (isBelowHeight(detection, reading, map))
    {
      ++unusable[reading.sensor + ": " + kBelowHeight + ", the bearing is used"];
      detection.range.reset();
    }
    reduceIdentity(detection, config.association, map);
    usable.push_back(std::move(detection));
  }
  reading.detections = std::move(usable);
  return reading;
}

std::optional<Reading> configured(const RangeScan& scan, const SensorConfigs& configs, const LandmarkTable& map,
                                  UnusableDetections& unusable)
{
  const auto& options = configOf(configs, scan.sensor).reflectors;
  const bool usable = options && !scan.intensities.empty();
  if (!usable)
  {
    ++unusable[scan.sensor + (options ? ": laser scan without intensities" : ": laser scan, extract is not set")];
    return std::nullopt;
  }
  Reflectors found = extractReflectors(scan, *options);
  if (found.too_wide > 0) unusable[scan.sensor + ": bright surface wider than a reflector"] += found.too_wide;
  return configured(reflectorReading(scan, std::move(found)), configs, map, unusable);
}

std::optional<RunningFixReading> configured(RunningFixReading fix, const SensorConfigs& configs,
                                            const LandmarkTable& map, UnusableDetections& unusable)
{
  const SensorConfig& config = configOf(configs, fix.sensor);
  fix.time -= config.delay;
  fix.first_time -= config.delay;
  fix.T_robot_sensor = configuredPlace(fix.T_robot_sensor, config);
  fix.model = configured(fix.model, config);
  correctRange(fix.first_range, fix.first_std, config, fix.sensor, fix.id);
  correctRange(fix.second_range, fix.second_std, config, fix.sensor, fix.id);
  if (fix.second_bearing) correctBearing(*fix.second_bearing, fix.second_bearing_std, config, fix.sensor);
  const std::string why = whyUnusable(fix, map, config.association);
  if (why.empty()) return fix;
  ++unusable[fix.sensor + ": " + why];
  return std::nullopt;
}

CompassRecord configured(CompassRecord compass, const SensorConfigs& configs)
{
  const SensorConfig& config = configOf(configs, compass.sensor);
  compass.time -= config.delay;
  compass.heading = wrap(compass.heading - config.bias_bearing);
  if (config.std_heading) compass.std_heading = *config.std_heading;
  if (!(compass.std_heading > 0)) throw missingStd(compass.sensor, "headings", "std_heading_deg");
  return compass;
}
}  // namespace mrpt_ext
