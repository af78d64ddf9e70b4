#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/tags/pinhole_camera.h"

namespace mrpt_ext
{
/// [px] in the image as the camera takes it, in order around the tag, either way.
using TagCorners = std::array<Eigen::Vector2d, 4>;

/// What is known of corners and of the way tags hang, as standard deviations.
struct TagNoise
{
  double std_corner = 0.5;           ///< [px] each way
  double std_upright = degToRad(3);  ///< [rad] of the edges that are upright, each way; large: tags hang anyhow
};

/// A pose in which a square is where its corners are seen: a local minimum of the negative log-likelihood.
struct TagPose
{
  Eigen::Matrix3d rotation;  ///< from the tag's axes to the camera's; the tag lies in x and y
  Eigen::Vector3d centre;    ///< [m] in camera axes
  /// Of a rotation about the centre [rad] and of the centre [m], in camera axes.
  Eigen::Matrix<double, 6, 6> covariance;
  double residual = 0;  ///< chi-squared: four degrees of freedom, two where tags hang anyhow
};

/// The poses of a square of this edge [m], most likely first: one, or two where a perspective too weak for the noise
/// leaves it open which side is nearer (Collins, Bartoli, "Infinitesimal plane-based pose estimation", 2014; here both
/// are found by descent, the second from the first, mirrored at the line of sight). None where the corners enclose no
/// area, are not convex or lie where the lens has no inverse.
/// Of a small tag seen from the front nothing but noise tells the attitude, and every tilt makes it seem nearer: its
/// range is too short by up to a standard deviation. Upright edges show the range without that.
[[nodiscard]] std::vector<TagPose> posesOfTag(const TagCorners& corners, double edge, const PinholeCamera& camera,
                                              const TagNoise& noise);
}  // namespace mrpt_ext
