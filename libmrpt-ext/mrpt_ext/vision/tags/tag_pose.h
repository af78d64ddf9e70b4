#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mrpt_ext/vision/tags/pinhole_camera.h"

namespace mrpt_ext
{
/// [px] in the image as the camera takes it, in order around the tag, either way.
using TagCorners = std::array<Eigen::Vector2d, 4>;

/// A pose in which a square is where its corners are seen: a local minimum of their distances in the image.
struct TagPose
{
  Eigen::Matrix3d rotation;    ///< from the tag's axes to the camera's; the tag lies in x and y
  Eigen::Vector3d centre;      ///< [m] in camera axes
  Eigen::Matrix3d covariance;  ///< of the centre [m^2], for corners with a standard deviation of 1 px
  double residual = 0;         ///< [px^2] sum of squared distances, two degrees of freedom
};

/// The poses of a square of this edge [m], most likely first: one, or two where a perspective too weak for the noise
/// leaves it open which side is nearer (Collins, Bartoli, "Infinitesimal plane-based pose estimation", 2014; here both
/// are found by descent, the second from the first, mirrored at the line of sight). None where the corners enclose no
/// area, are not convex or lie where the lens has no inverse.
[[nodiscard]] std::vector<TagPose> posesOfTag(const TagCorners& corners, double edge, const PinholeCamera& camera);
}  // namespace mrpt_ext
