#pragma once

#include <span>

#include "mrpt_ext/correspondence/global_pose_search.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"
#include "mrpt_ext/hypotheses/pose_region.h"
#include "mrpt_ext/relocalization/hypothesis_track.h"

namespace mrpt_ext
{
struct TrajectorySearchOptions
{
  double gate = 3.3;           ///< [standard deviations]
  std::size_t births = 6;      ///< looks that propose poses, the fullest, spread over the way
  double keep_log_units = 25;  ///< tracks less likely than the best by more are given up
  double missed = 0.02;        ///< probability that no look proposes the right pose
};

/// Where the robot may be at the end of a way.
struct TrajectorySearchResult
{
  SolveStatus status = SolveStatus::too_few;
  HypothesisSet hypotheses;          ///< likeliest first; weights leave room for `probability_elsewhere`
  double probability_elsewhere = 1;  ///< probability that none of them is right
  std::size_t proposed = 0;          ///< poses that the looks proposed
};

/// Finds a lost robot from what it saw, without names, along a way of any length. The looks with most detections
/// propose poses (correspondence/global_pose_search.h); each is carried along odometry, forward and back, and
/// confronted with all other looks (hypothesis_track.h); what falls behind is given up. Survivors start once more at
/// the beginning of the way from a pose that is hardly known, so that the evidences of all of them count every
/// detection once and compare. The poses that they have reached at the end are ranked by that evidence, beside the
/// evidence that a pose which no look has proposed would have.
///
/// In contrast to joining all looks into one constellation (correspondence/local_map/local_map.h), which odometry
/// limits to a few metres, the way may be long, and a look may be poor. Bearings alone propose poses by a grid over the
/// region (grid_search.h). `supposed`: poses at the end of the way that are judged with the others, by the same
/// evidence.
[[nodiscard]] TrajectorySearchResult localizeOverTrajectory(std::span<const TrajectoryStep> oldest_first,
                                                            const GlobalPoseSearch& search, const PoseRegion& region,
                                                            std::span<const GaussianPose> supposed = {},
                                                            const TrajectorySearchOptions& options = {});
}  // namespace mrpt_ext
