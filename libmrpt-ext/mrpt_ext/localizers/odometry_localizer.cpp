#include "mrpt_ext/localizers/odometry_localizer.h"

namespace mrpt_ext
{
Estimate OdometryLocalizer::process(const Frame& frame)
{
  pose_ = compound(pose_, frame.motion.increment, incrementCovariance(motion_, frame.motion));
  return {.status = SolveStatus::ok, .point = PoseEstimate{.time = frame.time, .pose = pose_}};
}
}  // namespace mrpt_ext
