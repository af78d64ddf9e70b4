#pragma once

#include "mrpt_ext/correspondence/global_pose_search.h"
#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"
#include "mrpt_ext/hypotheses/pose_region.h"

namespace mrpt_ext
{
struct ProposalOptions
{
  PoseRegion region;                 ///< poses outside are not proposed
  std::size_t max_hypotheses = 400;  ///< best ones kept
  std::size_t ring_points = 36;      ///< hypotheses that stand for a ring of unknown heading
  /// See PoseSearchOptions.
  std::uint64_t max_tree_nodes = PoseSearchOptions{}.max_tree_nodes;
};

/// All poses that the closed forms find in a frame, with covariance, scored by the likelihood of the whole frame and
/// ranked. Which solver seeds what: three bearings -> linear form and ML; pairs of range and
/// bearing -> rigid fit; three ranges -> position, heading from a bearing or free; one range and bearing, or a running
/// fix -> ring; detections without identity -> search for their constellation in the map (`search`, of this map).
/// Measurements may be partly wrong: solvers work on minimal subsets and the whole frame judges.
[[nodiscard]] HypothesisSet proposePoses(const Frame& frame, const LandmarkTable& map, const GlobalPoseSearch& search,
                                         const ProposalOptions& options);
}  // namespace mrpt_ext
