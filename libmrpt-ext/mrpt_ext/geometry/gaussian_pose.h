#pragma once

#include "mrpt_ext/geometry/pose.h"

namespace mrpt_ext
{
/// Pose with covariance, order (x, y, phi) [m, m, rad], world axes.
struct GaussianPose
{
  Pose2 mean;
  Matrix3d covariance = Matrix3d::Zero();
};
}  // namespace mrpt_ext
