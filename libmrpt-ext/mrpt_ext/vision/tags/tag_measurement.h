#pragma once

#include <optional>

#include "mrpt_ext/geometry/facing.h"
#include "mrpt_ext/vision/tags/tag_pose.h"

namespace mrpt_ext
{
/// The centre of a tag, seen from the camera in the robot's plane.
struct TagMeasurement
{
  double bearing = 0, std_bearing = 0;          ///< [rad] CCW from the camera's forward axis
  double range = 0, std_range = 0;              ///< [m] horizontal
  double correlation = 0;                       ///< of bearing and range
  double residual = 0;                          ///< chi-squared of the corners, as in TagPose
  std::optional<Facing> facing = std::nullopt;  ///< which way the tag faces (tag_facing.h)
};

/// Bearing and range with the covariance that independent errors of the corners cause. Of two poses that explain the
/// corners both count by their likelihoods, and what they disagree in is an error. Nothing where the corners show no
/// square, nor where the centre is so nearly above or below the camera that its bearing is open.
[[nodiscard]] std::optional<TagMeasurement> measureTag(const TagCorners& corners, double edge,
                                                       const PinholeCamera& camera, const TagNoise& noise);
}  // namespace mrpt_ext
