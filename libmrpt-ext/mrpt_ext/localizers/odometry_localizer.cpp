#include "mrpt_ext/localizers/odometry_localizer.h"

namespace mrpt_ext
{
Estimate OdometryLocalizer::process(const Frame& frame)
{
  const Pose2& step = frame.motion.increment;
  const Matrix3d F = composeJacobianFirst(pose_.mean, step), G = composeJacobianSecond(pose_.mean);
  pose_.covariance =
      F * pose_.covariance * F.transpose() + G * incrementCovariance(motion_, frame.motion) * G.transpose();
  pose_.mean = compose(pose_.mean, step);
  return {.status = SolveStatus::ok, .point = TrackPoint{.time = frame.time, .pose = pose_}};
}
}  // namespace mrpt_ext
