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
  PoseRegion region;                 ///< poses outside are dropped
  std::size_t max_hypotheses = 400;  ///< the best ones are kept
  PoseSearchOptions limits;          ///< max_tree_nodes and budget of the searches
};

/// Poses from closed forms over the measurements of a frame, with covariance, ranked by the likelihood of the whole
/// frame. Minimal subsets and their solvers: three bearings -> linear form and maximum likelihood; two landmarks with
/// range and bearing -> rigid fit; two ranges or more -> trilateration, heading from a bearing or unknown; one range
/// and bearing of a landmark that faces a known direction -> one pose or two; else, or from a running fix -> ring;
/// anonymous detections -> pose search (`search`, of this map). Outliers are tolerated: some minimal subset is free of
/// them, and the whole frame ranks its pose.
[[nodiscard]] HypothesisSet proposePoses(const Frame& frame, const LandmarkTable& map, const GlobalPoseSearch& search,
                                         const ProposalOptions& options);
}  // namespace mrpt_ext
