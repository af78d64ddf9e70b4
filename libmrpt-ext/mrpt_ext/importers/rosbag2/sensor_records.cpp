#include "mrpt_ext/importers/rosbag2/sensor_records.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/files/number_format.h"

namespace mrpt_ext
{
namespace
{
constexpr double kSameTime = 1e-3;  ///< [s] between a message and the transform made with it

/// A reading without detections.
Reading emptyReading(double time, const Pose3& T_robot_sensor, const Vector3d& forward = Vector3d::UnitX())
{
  Reading reading;
  reading.time = time;
  reading.T_robot_sensor = T_robot_sensor.planar(forward);
  reading.sensor_height = T_robot_sensor.position.z();
  return reading;
}

/// Bearing in the reading's frame of a direction given in the sensor's axes.
double bearingOf(const Vector3d& direction, const Pose3& T_robot_sensor, const Reading& reading)
{
  const Vector3d in_robot = T_robot_sensor.rotation * direction;
  return wrap(std::atan2(in_robot.y(), in_robot.x()) - reading.T_robot_sensor.phi);
}

/// Where the tag was when the image was taken, in the camera's frame.
std::optional<Vector3d> tagPosition(const RosTag& tag, const RosHeader& header, const TransformTree& transforms)
{
  for (const std::string& name :
       {tag.family + ":" + std::to_string(tag.id), "tag" + tag.family + ":" + std::to_string(tag.id)})
  {
    const auto& all = transforms.transforms({header.frame, name});
    const auto at = std::lower_bound(all.begin(), all.end(), header.time - kSameTime,
                                     [](const auto& transform, double time) { return transform.time < time; });
    if (at != all.end() && at->time <= header.time + kSameTime) return at->pose.position;
  }
  return std::nullopt;
}

void setRange(Detection& detection, double range, const RosSensorNoise& noise)
{
  detection.range = range;
  detection.std_range = noise.range + noise.range_per_m * range;
}

/// Standard deviations along and across the line of sight, where the covariance states them.
void setStatedNoise(Detection& detection, const RosObject& object)
{
  const double range = object.position.norm();
  if (!object.covariance.allFinite() || !(object.covariance.trace() > 0) || !(range > 0)) return;
  const Vector3d along = object.position / range;
  const Vector3d across = Vector3d::UnitZ().cross(along);
  const double radial = along.dot(object.covariance * along), lateral = across.dot(object.covariance * across);
  if (radial > 0) detection.std_range = std::sqrt(radial);
  if (lateral > 0) detection.std_bearing = std::sqrt(lateral) / range;
}
}  // namespace

std::optional<int> numberAtEnd(const std::string& name)
{
  const std::size_t before = name.find_last_not_of("0123456789");
  return parseInteger(before == std::string::npos ? name : name.substr(before + 1));
}

Reading readingOf(const RosTags& message, const RosCamera& camera, const Pose3& T_robot_sensor,
                  const TransformTree& transforms, const RosSensorNoise& noise)
{
  Reading reading = emptyReading(message.header.time, T_robot_sensor, Vector3d::UnitZ());
  for (const RosTag& tag : message.tags)
  {
    Detection detection{.id = tag.id, .category = {}, .bearing = {}, .range = {}};
    Vector3d ray((tag.u - camera.cx) / camera.fx, (tag.v - camera.cy) / camera.fy, 1);
    if (const auto position = tagPosition(tag, message.header, transforms))
    {
      ray = *position;
      setRange(detection, position->norm(), noise);
    }
    detection.bearing = bearingOf(ray, T_robot_sensor, reading);
    detection.std_bearing = noise.bearing;
    reading.detections.push_back(std::move(detection));
  }
  return reading;
}

Reading readingOf(const RosObjects& message, const Pose3& T_robot_sensor, const RosSensorNoise& noise)
{
  Reading reading = emptyReading(message.header.time, T_robot_sensor);
  for (const RosObject& object : message.objects)
  {
    const auto number = numberAtEnd(object.label);
    Detection detection{.id = number.value_or(kNoId),
                        .category = number ? std::string() : object.label,
                        .bearing = bearingOf(object.position, T_robot_sensor, reading),
                        .range = {},
                        .std_bearing = noise.bearing};
    setRange(detection, object.position.norm(), noise);
    setStatedNoise(detection, object);
    reading.detections.push_back(std::move(detection));
  }
  return reading;
}

Reading reflectorReadingOf(const RosObjects& message, const Pose3& T_robot_sensor, const RosSensorNoise& noise)
{
  Reading reading = emptyReading(message.header.time, T_robot_sensor);
  reading.horizontal_range = true;  // it is measured in the plane of the scan
  for (const RosObject& reflector : message.objects)
    reading.detections.push_back({.id = kNoId,
                                  .category = {},
                                  .bearing = bearingOf(reflector.position, T_robot_sensor, reading),
                                  .range = reflector.position.norm(),
                                  .std_bearing = noise.reflector_bearing,
                                  .std_range = noise.reflector_range});
  return reading;
}

Reading readingOf(const RosRange& message, int id, const Pose3& T_robot_sensor, const RosSensorNoise& noise)
{
  Reading reading = emptyReading(message.header.time, T_robot_sensor);
  const bool answered = message.range >= message.least && message.range <= message.most && message.range > 0;
  if (answered)
    reading.detections.push_back(
        {.id = id, .category = {}, .bearing = {}, .range = message.range, .std_bearing = 0, .std_range = noise.range});
  return reading;
}

RangeScan scanRecordOf(RosScan message, const Pose3& T_robot_sensor, const RosSensorNoise& noise)
{
  RangeScan scan;
  scan.time = message.header.time;
  scan.T_robot_sensor = T_robot_sensor.planar();
  scan.sensor_height = T_robot_sensor.position.z();
  // A scanner that hangs upside down turns the other way round.
  const double sense = T_robot_sensor.rotation(2, 2) < 0 ? -1 : 1;
  scan.first_bearing = sense * message.first_angle;
  scan.bearing_step = sense * message.angle_step;
  scan.std_range = noise.reflector_range;
  for (float& range : message.ranges)
    if (!(range >= message.least_range && range <= message.most_range)) range = 0;
  scan.ranges = std::move(message.ranges);
  scan.intensities = std::move(message.intensities);
  return scan;
}
}  // namespace mrpt_ext
