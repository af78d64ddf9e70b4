#include "mrpt_ext/rawlog/action_frames.h"

#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>

#include "mrpt_ext/observations/timestamps.h"

namespace mrpt_ext
{
std::optional<double> timeOf(const mrpt::system::TTimeStamp& stamp)
{
  return isValid(stamp) ? std::optional(secondsOf(stamp)) : std::nullopt;
}

std::optional<double> latestTime(const mrpt::obs::CSensoryFrame& frame)
{
  std::optional<double> latest;
  for (const auto& observation : frame)
    if (const auto time = timeOf(observation->timestamp)) latest = std::max(latest.value_or(*time), *time);
  return latest;
}

std::optional<mrpt::poses::CPose3D> incrementOf(const mrpt::obs::CAction& action)
{
  using mrpt::poses::CPose3D;
  if (const auto* move = dynamic_cast<const mrpt::obs::CActionRobotMovement2D*>(&action))
    return CPose3D(move->estimationMethod == mrpt::obs::CActionRobotMovement2D::emOdometry
                       ? move->rawOdometryIncrementReading
                       : move->poseChange->getMeanVal());
  if (const auto* move = dynamic_cast<const mrpt::obs::CActionRobotMovement3D*>(&action)) return move->poseChange.mean;
  return std::nullopt;
}
}  // namespace mrpt_ext
