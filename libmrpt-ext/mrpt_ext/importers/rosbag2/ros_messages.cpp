#include "mrpt_ext/importers/rosbag2/ros_messages.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mrpt_ext/geometry/physical_limits.h"
#include "mrpt_ext/importers/rosbag2/byte_reader.h"

namespace mrpt_ext
{
namespace
{
constexpr double kMetresPerMillimetre = 1e-3;

std::string frameName(const std::string& name) { return name.starts_with('/') ? name.substr(1) : name; }

RosHeader headerIn(const MessageValue& message)
{
  const double time = message.number("header.stamp.sec") + 1e-9 * message.number("header.stamp.nanosec");
  return {time, frameName(message.text("header.frame_id"))};
}

Vector3d vectorIn(const MessageValue& value)
{
  const Vector3d vector(value.number("x"), value.number("y"), value.number("z"));
  for (const double coordinate : vector)
    if (!isCoordinate(coordinate)) throw DamagedBytes("a coordinate of " + std::to_string(coordinate) + " m");
  return vector;
}

/// Nothing for a quaternion of zeros, which states no rotation.
std::optional<Matrix3d> rotationIn(const MessageValue& value)
{
  const Eigen::Quaterniond q(value.number("w"), value.number("x"), value.number("y"), value.number("z"));
  const double norm = q.norm();
  if (norm == 0) return std::nullopt;
  if (!(norm > 0.5 && norm < 2)) throw DamagedBytes("a quaternion of length " + std::to_string(norm) + ", expected 1");
  return q.normalized().toRotationMatrix();
}

RosPose poseFrom(const MessageValue& message, const MessageValue& position, const MessageValue& rotation)
{
  RosPose pose{.header = headerIn(message), .child_frame = {}, .pose = {}};
  pose.pose.position = vectorIn(position);
  const auto matrix = rotationIn(rotation);
  pose.has_rotation = matrix.has_value();
  if (matrix) pose.pose.rotation = *matrix;
  return pose;
}

RosPose poseFrom(const MessageValue& message, const MessageValue& pose)
{
  return poseFrom(message, pose.at("position"), pose.at("orientation"));
}

bool isOn(const MessageValue& value, const char* flag) { return value.find(flag) && value.number(flag) > 0; }

/// Of x, y and z, the first three of the six variables of a pose; row by row.
Matrix3d positionCovarianceIn(const std::vector<double>& covariance)
{
  if (covariance.size() != 36) throw DamagedBytes("a covariance of a pose without 36 elements");
  Matrix3d block;
  for (Eigen::Index row = 0; row < 3; ++row)
    for (Eigen::Index column = 0; column < 3; ++column)
      block(row, column) = covariance[static_cast<std::size_t>(6 * row + column)];
  return block;
}

RosObject objectFrom(const MessageValue& detection)
{
  RosObject object;
  const auto& results = detection.list("results");
  // The pose belongs to the best hypothesis, which comes first; without any, the box is all that is known.
  if (results.empty())
  {
    object.position = vectorIn(detection.at("bbox.center.position"));
    return object;
  }
  const MessageValue& best = results.front();
  object.position = vectorIn(best.at("pose.pose.position"));
  object.covariance = positionCovarianceIn(best.numbers("pose.covariance"));
  object.label = best.text(best.find("hypothesis.class_id") ? "hypothesis.class_id" : "id");
  return object;
}

Vector3d inPlane(double x, double y)
{
  if (!isCoordinate(x) || !isCoordinate(y)) throw DamagedBytes("a reflector at no position");
  return {x, y, 0};
}

/// The driver's own conversion first, then what the scanner measured: its axes are turned by half a circle against
/// those of its frame in ROS (sick_scan_xd's angle shift of a NAV350).
std::optional<Vector3d> reflectorPosition(const MessageValue& reflector)
{
  if (isOn(reflector, "pos_valid")) return inPlane(reflector.number("pos_x"), reflector.number("pos_y"));
  if (isOn(reflector, "polar_data_valid"))
  {
    const double range = kMetresPerMillimetre * reflector.number("dist");
    const double bearing = degToRad(1e-3 * reflector.number("phi"));
    return inPlane(-range * std::cos(bearing), -range * std::sin(bearing));
  }
  if (!isOn(reflector, "cartesian_data_valid")) return std::nullopt;
  return inPlane(-kMetresPerMillimetre * reflector.number("x"), -kMetresPerMillimetre * reflector.number("y"));
}

/// The numbers as float32, which they are; NaN for what a strange definition makes of them.
std::vector<float> floatsIn(const std::vector<double>& numbers)
{
  std::vector<float> floats;
  for (const double number : numbers)
  {
    const bool fits = std::isinf(number) || std::abs(number) <= std::numeric_limits<float>::max();
    floats.push_back(fits ? static_cast<float>(number) : std::numeric_limits<float>::quiet_NaN());
  }
  return floats;
}

int idIn(const MessageValue& value)
{
  const double id = value.number("id");
  if (!(std::abs(id) <= std::numeric_limits<int>::max())) throw DamagedBytes("an id that is no integer of 32 bits");
  return static_cast<int>(id);
}
}  // namespace

RosPose odometryIn(const MessageValue& message)
{
  RosPose pose = poseFrom(message, message.at("pose.pose"));
  pose.child_frame = frameName(message.text("child_frame_id"));
  return pose;
}

RosPose stampedPoseIn(const MessageValue& message) { return poseFrom(message, message.at("pose")); }
RosPose uncertainPoseIn(const MessageValue& message) { return poseFrom(message, message.at("pose.pose")); }

RosPose pointIn(const MessageValue& message)
{
  RosPose pose{.header = headerIn(message), .child_frame = {}, .pose = {}, .has_rotation = false};
  pose.pose.position = vectorIn(message.at("point"));
  return pose;
}

RosPose transformIn(const MessageValue& message)
{
  RosPose pose = poseFrom(message, message.at("transform.translation"), message.at("transform.rotation"));
  pose.child_frame = frameName(message.text("child_frame_id"));
  return pose;
}

RosTags tagsIn(const MessageValue& message)
{
  RosTags tags{headerIn(message), {}};
  for (const MessageValue& detection : message.list("detections"))
  {
    RosTag tag{.family = detection.text("family"), .id = idIn(detection)};
    const MessageValue& centre = detection.at("centre");
    if (centre.isStructure())
    {
      tag.u = centre.number("x");
      tag.v = centre.number("y");
    }
    else
    {
      const auto& pixel = detection.numbers("centre");
      if (pixel.size() != 2) throw DamagedBytes("the centre of a tag without two coordinates");
      tag.u = pixel[0];
      tag.v = pixel[1];
    }
    if (!isCoordinate(tag.u) || !isCoordinate(tag.v)) throw DamagedBytes("the centre of a tag is no pixel");
    tags.tags.push_back(std::move(tag));
  }
  return tags;
}

std::optional<RosCamera> cameraIn(const MessageValue& message)
{
  const auto& projection = message.numbers("p");
  const auto& intrinsic = message.numbers("k");
  if (projection.size() != 12 || intrinsic.size() != 9) throw DamagedBytes("camera matrices of a wrong size");
  RosCamera camera{headerIn(message), projection[0], projection[5], projection[2], projection[6]};
  if (!(camera.fx > 0)) camera = {camera.header, intrinsic[0], intrinsic[4], intrinsic[2], intrinsic[5]};
  const bool calibrated = camera.fx > 0 && camera.fy > 0 && isCoordinate(camera.fx) && isCoordinate(camera.fy) &&
                          isCoordinate(camera.cx) && isCoordinate(camera.cy);
  if (!calibrated) return std::nullopt;
  return camera;
}

RosObjects objectsIn(const MessageValue& message)
{
  RosObjects objects{headerIn(message), {}};
  for (const MessageValue& detection : message.list("detections")) objects.objects.push_back(objectFrom(detection));
  return objects;
}

RosObjects reflectorsIn(const MessageValue& message)
{
  RosObjects reflectors{headerIn(message), {}};
  for (const MessageValue& reflector : message.list("reflectors"))
    if (const auto position = reflectorPosition(reflector))
      reflectors.objects.push_back({.position = *position, .covariance = Matrix3d::Zero(), .label = {}});
  return reflectors;
}

RosRange rangeIn(const MessageValue& message)
{
  return {headerIn(message), message.number("range"), message.number("min_range"), message.number("max_range")};
}

RosScan scanIn(const MessageValue& message)
{
  RosScan scan{.header = headerIn(message),
               .first_angle = message.number("angle_min"),
               .angle_step = message.number("angle_increment"),
               .least_range = message.number("range_min"),
               .most_range = message.number("range_max"),
               .ranges = floatsIn(message.numbers("ranges")),
               .intensities = floatsIn(message.numbers("intensities"))};
  const double span = std::abs(scan.angle_step) * static_cast<double>(scan.ranges.size());
  if (!(std::abs(scan.first_angle) <= 2 * kTwoPi) || !(span <= 2 * kTwoPi))
    throw DamagedBytes("the angles of a scan go beyond a full turn");
  if (!scan.intensities.empty() && scan.intensities.size() != scan.ranges.size())
    throw DamagedBytes(std::to_string(scan.ranges.size()) + " ranges, but " + std::to_string(scan.intensities.size()) +
                       " intensities");
  return scan;
}
}  // namespace mrpt_ext
