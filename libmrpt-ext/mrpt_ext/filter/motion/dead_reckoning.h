#pragma once

#include "mrpt_ext/filter/motion/motion_model.h"

namespace mrpt_ext
{
/// Pose by odometry alone, in axes of its own.
struct DeadReckoning
{
  Pose2 pose;                   ///< [m, rad] since the start
  double heading_variance = 0;  ///< of its drift since then [rad^2]
  double walk_variance = 0;     ///< without odometry: of the position since then [m^2]

  void move(const MotionModel& model, const OdometryMotion& motion)
  {
    pose = compose(pose, nominalMotion(model, motion).increment);
    heading_variance += incrementCovariance(model, motion)(2, 2);
    if (model.type == MotionType::random_walk) walk_variance += incrementStd(model, motion).head<2>().squaredNorm();
  }
};

/// Expected squared distance [m^2] between two positions on one path.
[[nodiscard]] inline double squaredDistance(const DeadReckoning& earlier, const DeadReckoning& later)
{
  return (later.pose.position() - earlier.pose.position()).squaredNorm() + later.walk_variance - earlier.walk_variance;
}
}  // namespace mrpt_ext
