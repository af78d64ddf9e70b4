#pragma once

#include "mrpt_ext/evaluation/run_record.h"

namespace mrpt_ext
{
inline constexpr const char* kOdometryMethod = "odometry";

/// Dead reckoning lives in its own frame. To be drawn and judged it is moved as a whole so that it agrees with the
/// first truth pose with a heading at or after its first point; it is not aligned any further. Without such a
/// truth pose it stays in its own frame (returns false) and cannot be judged.
[[nodiscard]] bool alignWithTruth(MethodTrajectory& odometry, const Trajectory& truth);

/// The record with its method `odometry` aligned, or with that method's trajectory unchanged where it cannot be.
[[nodiscard]] RunRecord withAlignedOdometry(RunRecord record, const Trajectory& truth);
}  // namespace mrpt_ext
