#pragma once

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext
{
inline constexpr const char* kOdometryMethod = "odometry";

/// Moves dead reckoning, which has its own frame, as a whole so that it agrees with the first truth pose with a heading
/// at or after its first point. Returns false without such a truth pose: then it stays in its own frame and has no
/// error.
[[nodiscard]] bool alignWithTruth(MethodTrajectory& odometry, const Trajectory& truth);

/// The record with its method `odometry` aligned, or with that method's trajectory unchanged where it cannot be.
[[nodiscard]] RunRecord withAlignedOdometry(RunRecord record, const Trajectory& truth);
}  // namespace mrpt_ext
