#pragma once

#include <vector>

#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/solvers/running_fix.h"

namespace mrpt_ext
{
/// Heading of the robot at the second range, from a compass or a filter.
struct HeadingPrior
{
  double heading = 0;      ///< [rad], world
  double std_heading = 0;  ///< [rad], > 0
};

[[nodiscard]] inline HeadingPrior headingOf(const GaussianPose& pose)
{
  return {pose.mean.phi, std::sqrt(pose.covariance(2, 2))};
}

struct RunningFixPose
{
  GaussianPose pose;      ///< of the robot (not of the sensor) at the second range
  double log_score = 0;   ///< log-density of the second bearing, 0 without one: tells the candidates apart
  bool from_gap = false;  ///< the ranges contradict each other; see runningFix
};

struct RunningFixPoses
{
  SolveStatus status = SolveStatus::bad_input;
  CircleRelation relation = CircleRelation::not_finite;
  std::vector<RunningFixPose> candidates;  ///< best first
};

/// Robot poses from a logged running fix and a heading: runningFix with the displacement (and the sensor's offset)
/// turned into world axes. The covariance counts that a heading error turns the displacement, so position and heading
/// are correlated. `fix` must hold horizontal ranges. Without any heading the answer is a ring: see pose_ring and
/// landmark_in_robot_frame.
[[nodiscard]] RunningFixPoses runningFixPoses(const RunningFixReading& fix, const Vector2d& landmark,
                                              const HeadingPrior& heading);
}  // namespace mrpt_ext
