#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/importers/rosbag2/message_value.h"
#include "mrpt_ext/importers/rosbag2/pose3.h"

namespace mrpt_ext
{
struct RosHeader
{
  double time = 0;    ///< [s]
  std::string frame;  ///< without a leading slash
};

/// A stamped pose of any message type.
struct RosPose
{
  RosHeader header;
  std::string child_frame;   ///< empty: not stated
  Pose3 pose;                ///< of the child in the frame of the header
  bool has_rotation = true;  ///< false for points and a quaternion of zeros
};

/// A tag in an image.
struct RosTag
{
  std::string family;
  int id = 0;
  double u = 0, v = 0;  ///< [pixel] centre
};
struct RosTags
{
  RosHeader header;
  std::vector<RosTag> tags;
};

/// The pinhole model of rectified images.
struct RosCamera
{
  RosHeader header;
  double fx = 0, fy = 0, cx = 0, cy = 0;  ///< [pixel]
};

/// A detected object: its position, and perhaps what it is.
struct RosObject
{
  Vector3d position = Vector3d::Zero();    ///< [m] in the frame of the header
  Matrix3d covariance = Matrix3d::Zero();  ///< zero: not stated
  std::string label;                       ///< empty: none
};
struct RosObjects
{
  RosHeader header;
  std::vector<RosObject> objects;
};

struct RosRange
{
  RosHeader header;
  double range = 0, least = 0, most = 0;  ///< [m]
};

struct RosScan
{
  RosHeader header;
  double first_angle = 0, angle_step = 0;  ///< [rad]
  double least_range = 0, most_range = 0;  ///< [m]
  std::vector<float> ranges;               ///< [m]
  std::vector<float> intensities;          ///< as many, or none
};

/// Messages as plain values. Throw DamagedBytes where the message lacks a field or states what cannot be.
[[nodiscard]] RosPose odometryIn(const MessageValue& message);       ///< nav_msgs/Odometry
[[nodiscard]] RosPose stampedPoseIn(const MessageValue& message);    ///< geometry_msgs/PoseStamped
[[nodiscard]] RosPose uncertainPoseIn(const MessageValue& message);  ///< geometry_msgs/PoseWithCovarianceStamped
[[nodiscard]] RosPose pointIn(const MessageValue& message);          ///< geometry_msgs/PointStamped
[[nodiscard]] RosPose transformIn(const MessageValue& message);      ///< geometry_msgs/TransformStamped
[[nodiscard]] RosTags tagsIn(const MessageValue& message);           ///< apriltag_msgs/AprilTagDetectionArray
[[nodiscard]] std::optional<RosCamera> cameraIn(
    const MessageValue& message);                                    ///< sensor_msgs/CameraInfo; uncalibrated: none
[[nodiscard]] RosObjects objectsIn(const MessageValue& message);     ///< vision_msgs/Detection3DArray
[[nodiscard]] RosObjects reflectorsIn(const MessageValue& message);  ///< sick_scan_xd/NAVLandmarkData
[[nodiscard]] RosRange rangeIn(const MessageValue& message);         ///< sensor_msgs/Range
[[nodiscard]] RosScan scanIn(const MessageValue& message);           ///< sensor_msgs/LaserScan
}  // namespace mrpt_ext
