#include "mrpt_ext/simulation/sensor_simulator.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/measurement_jacobian.h"
#include "mrpt_ext/simulation/rounding.h"

namespace mrpt_ext
{
namespace
{
bool measuresBearings(const SimulatedSensor& sensor) { return sensor.kind != SensorKind::ranges; }
bool measuresRanges(const SimulatedSensor& sensor) { return sensor.kind != SensorKind::bearings; }

std::uint64_t landmarksIn(const std::vector<SceneFeature>& features)
{
  const auto is_landmark = [](const SceneFeature& feature) { return feature.is_landmark; };
  return static_cast<std::uint64_t>(std::count_if(features.begin(), features.end(), is_landmark));
}

/// Index of another landmark, all with equal chances; itself when it is the only one.
std::size_t otherLandmark(std::size_t itself, const std::vector<SceneFeature>& features, RandomStream& random)
{
  const std::uint64_t count = landmarksIn(features);
  return count > 1 ? (itself + 1 + random.below(count - 1)) % count : itself;
}

/// The identity as far as the sensor determines it.
void identify(Detection& detection, const SimulatedSensor& sensor, const SceneFeature& feature)
{
  if (sensor.identity == IdentityLevel::known) detection.id = feature.id;
  if (sensor.identity != IdentityLevel::anonymous) detection.category = feature.category;
}

/// Depth / range: an ordinary stereo pair measures the depth along its axis, an omnidirectional one the range itself.
double depthShare(const SimulatedSensor& sensor, double bearing)
{
  return sensor.field_of_view < degToRad(170) ? std::cos(bearing) : 1;
}

double declaredRangeStd(const SimulatedSensor& sensor, double range, double bearing)
{
  const double std_stereo = sensor.std_disparity > 0 ? square(range) * depthShare(sensor, bearing) *
                                                           sensor.std_disparity / sensor.baseline_focal
                                                     : 0;
  return rounded(std::hypot(sensor.std_range, sensor.std_range_per_m * range, std_stereo));
}

std::optional<Detection> detect(const SimulatedSensor& sensor, const VisibleFeature& feature,
                                const std::vector<SceneFeature>& features, RandomStream& random)
{
  if (!random.chance(sensor.detection_probability)) return std::nullopt;
  Detection detection;
  std::size_t reported = feature.feature;
  if (features[reported].is_landmark && random.chance(sensor.wrong_identity_probability))
    reported = otherLandmark(reported, features, random);
  identify(detection, sensor, features[reported]);
  if (measuresBearings(sensor))
  {
    detection.bearing = measureBearing(sensor, feature, random);
    detection.std_bearing = rounded(sensor.std_bearing);
  }
  if (measuresRanges(sensor))
  {
    const auto measured = measureRange(sensor, feature, random);
    if (!measured) return std::nullopt;
    detection.range = measured->range;
    detection.std_range = measured->std_range;
  }
  return detection;
}

/// A false detection: anywhere in view, with the identity of any landmark.
Detection detectNothing(const SimulatedSensor& sensor, const std::vector<SceneFeature>& features, RandomStream& random)
{
  Detection detection;
  const std::uint64_t names = landmarksIn(features);
  if (names > 0) identify(detection, sensor, features[random.below(names)]);
  const double bearing = roundedAngle(random.uniform(-0.5, 0.5) * sensor.field_of_view);
  const double range = rounded(random.uniform(sensor.min_range, sensor.max_range.value_or(sensor.min_range)));
  if (measuresBearings(sensor))
  {
    detection.bearing = bearing;
    detection.std_bearing = rounded(sensor.std_bearing);
  }
  if (measuresRanges(sensor))
  {
    detection.range = range;
    detection.std_range = declaredRangeStd(sensor, range, bearing);
  }
  return detection;
}

/// Seen from a sensor [rad, m horizontal].
struct Direction
{
  double bearing = 0, distance = 0;
};

/// Something that hides what is behind it.
struct Occluder
{
  Direction direction;
  double radius = 0;  // [m]
};

/// True when a nearer occluder covers the centre of a feature.
bool isHidden(const Direction& feature, const std::vector<Occluder>& occluders)
{
  return std::any_of(occluders.begin(), occluders.end(),
                     [&](const Occluder& o)
                     {
                       if (!(o.direction.distance < feature.distance)) return false;
                       const double angle = std::abs(wrap(feature.bearing - o.direction.bearing));
                       return angle < kPi / 2 && o.direction.distance * std::sin(angle) < o.radius;
                     });
}

void shuffle(std::vector<Detection>& detections, RandomStream& random)
{
  for (std::size_t i = detections.size(); i > 1; --i) std::swap(detections[i - 1], detections[random.below(i)]);
}
}  // namespace

std::vector<VisibleFeature> visibleFeatures(const SimulatedSensor& sensor, const Pose2& robot,
                                            const std::vector<SceneFeature>& features)
{
  const Vector2d lever = sensor.lever_arm;
  const Pose2 T_robot_sensor{sensor.T_robot_sensor.x + lever.x(), sensor.T_robot_sensor.y + lever.y(),
                             sensor.T_robot_sensor.phi};
  const auto directionOf = [&](const SceneFeature& feature) -> Direction
  {
    const Vector2d position = feature.position.head<2>();
    return {predictBearing(robot, position, T_robot_sensor), predictRange(robot, position, T_robot_sensor)};
  };
  std::vector<Occluder> occluders;
  for (const SceneFeature& feature : features)
    if (feature.radius > 0) occluders.push_back({directionOf(feature), feature.radius});
  std::vector<VisibleFeature> visible;
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    const Direction direction = directionOf(features[i]);
    const auto [bearing, distance] = direction;
    if (!features[i].is_landmark && !sensor.sees_objects) continue;
    if (std::abs(bearing) > 0.5 * sensor.field_of_view || distance < sensor.min_range) continue;
    if (sensor.max_range && distance > *sensor.max_range) continue;
    if (isHidden(direction, occluders)) continue;
    const double rise = features[i].position.z() - sensor.height;
    visible.push_back({i, bearing, sensor.horizontal_range ? distance : std::hypot(distance, rise)});
  }
  return visible;
}

std::optional<MeasuredRange> measureRange(const SimulatedSensor& sensor, const VisibleFeature& feature,
                                          RandomStream& random)
{
  double range = feature.range;
  if (sensor.std_disparity > 0)
  {
    const double share = depthShare(sensor, feature.bearing);
    const double disparity = sensor.baseline_focal / (range * share) + sensor.std_disparity * random.gaussian();
    if (!(disparity > 0)) return std::nullopt;
    range = sensor.baseline_focal / disparity / share;
  }
  const double std = std::hypot(sensor.std_range, sensor.std_range_per_m * feature.range);
  range = rounded(sensor.scale_range * range + sensor.bias_range + std * random.gaussian());
  if (!(range > 0)) return std::nullopt;
  return MeasuredRange{range, declaredRangeStd(sensor, range, feature.bearing)};
}

double measureBearing(const SimulatedSensor& sensor, const VisibleFeature& feature, RandomStream& random)
{
  return roundedAngle(feature.bearing + sensor.bias_bearing + sensor.std_bearing * random.gaussian());
}

SensorModel declaredModel(const SimulatedSensor& sensor)
{
  SensorModel model;
  model.field_of_view = rounded(sensor.field_of_view);
  model.has_field_of_view = true;
  model.max_range = sensor.max_range;
  return model;
}

Reading simulateReading(const SimulatedSensor& sensor, const Pose2& robot, const std::vector<SceneFeature>& features,
                        RandomStream& random)
{
  Reading reading;
  reading.sensor = sensor.label;
  reading.T_robot_sensor = rounded(sensor.T_robot_sensor);
  reading.sensor_height = sensor.height;
  reading.horizontal_range = sensor.horizontal_range;
  reading.model = declaredModel(sensor);
  for (const VisibleFeature& feature : visibleFeatures(sensor, robot, features))
    if (const auto detection = detect(sensor, feature, features, random)) reading.detections.push_back(*detection);
  for (int left = random.poisson(sensor.clutter_per_reading); left > 0; --left)
    reading.detections.push_back(detectNothing(sensor, features, random));
  shuffle(reading.detections, random);
  if (sensor.max_detections && reading.detections.size() > static_cast<std::size_t>(*sensor.max_detections))
    reading.detections.resize(static_cast<std::size_t>(*sensor.max_detections));
  return reading;
}

CompassRecord simulateCompass(const SimulatedSensor& sensor, const Pose2& robot, RandomStream& random)
{
  const double heading = robot.phi + sensor.bias_heading + sensor.std_heading * random.gaussian();
  return {0, sensor.label, roundedAngle(heading), rounded(sensor.std_heading)};
}
}  // namespace mrpt_ext
