#pragma once

#include <Eigen/Core>
#include <array>

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
}  // namespace mrpt_ext
