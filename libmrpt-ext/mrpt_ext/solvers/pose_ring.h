#pragma once

#include <vector>

#include "mrpt_ext/geometry/facing.h"
#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/solvers/gaussian_point.h"

namespace mrpt_ext
{
/// All poses with the same range and bearing of one landmark: the heading is free, and with it the position on a circle
/// about the landmark (paper 004; equations of the running fix, observability).
struct PoseRing
{
  Vector2d landmark{0, 0};      ///< world frame [m]
  GaussianPoint seen_in_robot;  ///< the landmark in the robot frame [m]
};

/// Ring from a horizontal range and a bearing taken by a sensor at `T_robot_sensor` on the robot.
[[nodiscard]] PoseRing makePoseRing(const Vector2d& landmark, double range, double std_range, double bearing,
                                    double std_bearing, const Pose2& T_robot_sensor = {});

/// The pose of the ring with this heading: p = l - Rot(h) v. For a sensor in the robot centre p = l - r (cos(h+b),
/// sin(h+b)).
[[nodiscard]] Pose2 poseOnRing(const PoseRing& ring, double heading);

/// The same with covariance, for a heading known to `std_heading` [rad]; position and heading are correlated.
[[nodiscard]] GaussianPose gaussianOnRing(const PoseRing& ring, double heading, double std_heading);

struct PoseOnRing
{
  GaussianPose pose;
  double probability = 0;
};

/// The poses of the ring with one of these headings, likelier first, of the robot in the world: a single landmark that
/// faces a known direction gives one pose, or two.
[[nodiscard]] std::vector<PoseOnRing> posesOnRing(const PoseRing& ring, const Facing& headings);
}  // namespace mrpt_ext
