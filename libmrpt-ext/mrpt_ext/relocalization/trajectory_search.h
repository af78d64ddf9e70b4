#pragma once

#include <span>

#include "mrpt_ext/correspondence/global_pose_search.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"
#include "mrpt_ext/hypotheses/pose_region.h"
#include "mrpt_ext/relocalization/hypothesis_track.h"

namespace mrpt_ext
{
/// Robot poses at the end of a trajectory.
struct TrajectorySearchResult
{
  SolveStatus status = SolveStatus::too_few;
  HypothesisSet hypotheses;          ///< most likely first; the weights and `probability_elsewhere` add up to 1
  double probability_elsewhere = 1;  ///< that none of them is right
  bool finished = true;              ///< false: the work was ended, poses may be missing
};

/// Global localization from the anonymous detections of a whole trajectory, by multi-hypothesis tracking:
/// 1. The steps with most detections, spread over the trajectory, propose poses: by global_pose_search.h where ranges
///    are measured, else by a grid over the region (grid_search.h). Poses `current` at the end compete with them.
/// 2. Every proposal becomes a track (hypothesis_track.h), updated with all steps after its own and before it; tracks
///    much less likely than the best one are pruned.
/// 3. The survivors start again at the beginning, with the same wide covariance and the associations found: then the
///    evidence of each covers every detection once, and evidences can be compared.
/// 4. Their poses at the end are weighted by that evidence, against the evidence expected of a pose that no step
///    proposed.
/// Odometry drift limits a local map of the detections (correspondence/local_map/local_map.h) to a few metres; here the
/// trajectory may be long and each scan may be poor.
///
/// Each step that proposes has an equal share of `budget`; where its share ends, its poses are left out, and
/// `finished` is false.
[[nodiscard]] TrajectorySearchResult localizeOverTrajectory(std::span<const TrajectoryStep> oldest_first,
                                                            const GlobalPoseSearch& search, const PoseRegion& region,
                                                            std::span<const GaussianPose> current, WorkBudget& budget);
/// The same within the budget of one step of a localizer.
[[nodiscard]] TrajectorySearchResult localizeOverTrajectory(std::span<const TrajectoryStep> oldest_first,
                                                            const GlobalPoseSearch& search, const PoseRegion& region,
                                                            std::span<const GaussianPose> current = {});
}  // namespace mrpt_ext
