#pragma once

#include "mrpt_ext/filter/motion_model.h"

namespace mrpt_ext
{
/// Where odometry says that the robot is, in axes of its own, and how far its heading may have drifted since it began.
struct DeadReckoning
{
  Pose2 pose;
  double heading_variance = 0;  ///< [rad^2]

  void move(const MotionModel& model, const OdometryMotion& motion)
  {
    pose = compose(pose, believedMotion(model, motion).increment);
    heading_variance += incrementCovariance(model, motion)(2, 2);
  }
};
}  // namespace mrpt_ext
