#pragma once

#include <span>

#include "mrpt_ext/correspondence/global_pose_search.h"
#include "mrpt_ext/correspondence/tree/tree_search.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"
#include "mrpt_ext/hypotheses/pose_region.h"

namespace mrpt_ext
{
/// Result of proposeFromAssociation().
struct AssociationProposals
{
  SolveStatus status = SolveStatus::too_few;
  HypothesisSet hypotheses;  ///< robot poses in the region, most likely first; log_score: log-evidence
  bool unique = false;       ///< one pose dominates, and a false one as good is unlikely
};

/// All robot poses in the region for which the anonymous detections can be associated with landmarks (paper 000,
/// section 3, for maps of any size: global_pose_search.h). Readings of several sensors are searched jointly; those of a
/// window, oldest first, are merged into one local map first (local_map.h).
/// `map` must be the table of `search`. Of `limits`, max_tree_nodes and budget are used.
[[nodiscard]] AssociationProposals proposeFromAssociation(std::span<const Reading> readings, const LandmarkTable& map,
                                                          const GlobalPoseSearch& search, const PoseRegion& region,
                                                          const PoseSearchOptions& limits = {});

/// Poses from three bearings, or from three out of four, by the interpretation tree: many, and none verified. For
/// initialization only, where proposeFromAssociation() has too few detections; empty with more than four bearings or
/// more than kLargestTreeMap landmarks.
[[nodiscard]] HypothesisSet proposeFromThreeBearings(std::span<const Reading> readings, const LandmarkTable& map,
                                                     const GlobalPoseSearch& search, const PoseRegion& region,
                                                     const PoseSearchOptions& limits = {});
}  // namespace mrpt_ext
