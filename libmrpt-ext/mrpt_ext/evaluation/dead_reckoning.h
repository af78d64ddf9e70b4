#pragma once

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/geometry/trajectory.h"

namespace mrpt_ext
{
/// Robot motion between two times by dead reckoning: later pose in the frame of the earlier one. Odometry is
/// interpolated over gaps of any length and holds its first and last pose outside; without odometry: identity.
[[nodiscard]] Pose2 motionBetween(const Trajectory& odometry, double from, double to);

/// Estimate carried to `time` by dead reckoning, with its covariance turned along (odometry's own noise is not
/// added). An estimate without a heading stays where it is: the direction of the motion is not known.
[[nodiscard]] PoseEstimate carry(const PoseEstimate& estimate, const Trajectory& odometry, double time);
}  // namespace mrpt_ext
