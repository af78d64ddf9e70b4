#pragma once

#include "mrpt_ext/filter/motion/motion_model.h"

namespace mrpt_ext
{
/// Pose by odometry alone, in axes of its own.
struct DeadReckoning
{
  Pose2 pose;                   ///< [m, rad] since the start
  double heading_variance = 0;  ///< of its drift since then [rad^2]

  void move(const MotionModel& model, const OdometryMotion& motion)
  {
    pose = compose(pose, nominalMotion(model, motion).increment);
    heading_variance += incrementCovariance(model, motion)(2, 2);
  }
};
}  // namespace mrpt_ext
