#pragma once

#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/solvers/gaussian_point.h"

namespace mrpt_ext
{
/// A seen thing in world coordinates (paper 001, eq 9-10): p + Rot(h) v, with covariance from the robot's pose and from
/// the sighting. In the paper's frames the same is Rot(beta) (object + (X_r, Y_r)).
[[nodiscard]] GaussianPoint objectPosition(const GaussianPose& robot, const GaussianPoint& in_robot);
}  // namespace mrpt_ext
