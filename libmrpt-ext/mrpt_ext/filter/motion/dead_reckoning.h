#pragma once

#include "mrpt_ext/filter/motion/motion_model.h"

namespace mrpt_ext
{
/// Where odometry says that the robot is, in axes of its own.
struct DeadReckoning
{
  Pose2 pose;                   ///< [m, rad] since it began
  double heading_variance = 0;  ///< of its drift since then [rad^2]

  void move(const MotionModel& model, const OdometryMotion& motion)
  {
    pose = compose(pose, believedMotion(model, motion).increment);
    heading_variance += incrementCovariance(model, motion)(2, 2);
  }
};
}  // namespace mrpt_ext
