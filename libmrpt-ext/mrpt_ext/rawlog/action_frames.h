#pragma once

#include <mrpt/system/datetime.h>

#include <optional>

namespace mrpt::obs
{
class CAction;
class CSensoryFrame;
}  // namespace mrpt::obs

namespace mrpt::poses
{
class CPose3D;
}  // namespace mrpt::poses

/// Entries of logs in action/sensory-frame form.
namespace mrpt_ext
{
/// Unix time [s]; nothing for a stamp that is not set.
[[nodiscard]] std::optional<double> timeOf(const mrpt::system::TTimeStamp& stamp);

/// The latest time in the frame [s]; nothing when no observation has one.
[[nodiscard]] std::optional<double> latestTime(const mrpt::obs::CSensoryFrame& frame);

/// Motion in the frame of the robot before the action; nothing when the action is no movement of the robot.
[[nodiscard]] std::optional<mrpt::poses::CPose3D> incrementOf(const mrpt::obs::CAction& action);
}  // namespace mrpt_ext
