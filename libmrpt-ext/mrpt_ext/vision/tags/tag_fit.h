#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "mrpt_ext/vision/tags/tag_values.h"

// The descent that the poses of a tag and the direction it faces share.
namespace mrpt_ext
{
/// Corners of a square with an edge of 2, in the order of TagCorners.
inline const std::array<Eigen::Vector2d, 4> kSquare{Eigen::Vector2d(-1, 1), Eigen::Vector2d(1, 1),
                                                    Eigen::Vector2d(1, -1), Eigen::Vector2d(-1, -1)};

struct RigidPose
{
  Eigen::Matrix3d rotation;  ///< from the tag's axes to the camera's
  Eigen::Vector3d centre;    ///< [m] in camera axes
};

/// What is seen of a tag, and of which size it is.
struct TagSight
{
  const TagCorners& corners;
  double edge;  ///< [m]
  const PinholeCamera& camera;
  TagNoise noise;
  Eigen::Matrix3d level;  ///< from camera axes to level ones

  TagSight(const TagCorners& seen, double edge_length, const PinholeCamera& by, const TagNoise& with)
      : corners(seen), edge(edge_length), camera(by), noise(with), level(by.levelAxes())
  {
  }
};

/// Where a tag's normal points that is on the camera's side.
struct TagNormal
{
  double yaw = 0;                  ///< [rad] from above, CCW from the camera's forward axis
  Eigen::RowVector3d by_rotation;  ///< derivative of the yaw by a rotation about the centre, in camera axes
  double horizontal = 0;           ///< length of its horizontal part: 0 for a tag that lies on the floor
  double towards = 0;              ///< cosine between it and the way to the camera: 0 for a tag that is seen edge-on
};
[[nodiscard]] TagNormal normalOf(const RigidPose& pose, const TagSight& sight);

struct DescentOfTag
{
  int steps = 40;
  double accuracy = 1e-10;                   ///< ends with a step that takes less off the misfit, as a share of it
  std::optional<double> yaw = std::nullopt;  ///< [rad] that the normal is held at
};

/// From a pose into the minimum of the misfit that it lies above, with its covariance unless the yaw is held; nothing
/// where the corners do not determine a pose.
[[nodiscard]] std::optional<TagPose> descended(RigidPose pose, const TagSight& sight, const DescentOfTag& how = {});
}  // namespace mrpt_ext
