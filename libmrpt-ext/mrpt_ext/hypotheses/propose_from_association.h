#pragma once

#include <span>

#include "mrpt_ext/correspondence/global_pose_search.h"
#include "mrpt_ext/correspondence/tree/tree_search.h"
#include "mrpt_ext/geometry/measurement.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"
#include "mrpt_ext/hypotheses/pose_region.h"

namespace mrpt_ext
{
/// What the unidentified detections of some readings say about the robot's pose.
struct ReadingInterpretation
{
  SolveStatus status = SolveStatus::too_few;
  HypothesisSet hypotheses;  ///< robot poses in the region, likeliest first; log_score: log-evidence
  bool unique = false;       ///< one pose stands out, and chance hardly makes such poses
  bool finished = true;      ///< false: the search gave up, poses may be missing
};

/// All robot poses in the region from which the unidentified detections can be explained (paper 000, section 3, at any
/// scale: global_pose_search.h). Readings of several places are explained together; those of
/// several moments, oldest first, are joined through odometry into one constellation first (local_map.h).
/// `map` must be the table of `search`. `max_tree_nodes`: see PoseSearchOptions.
[[nodiscard]] ReadingInterpretation interpretReadings(
    std::span<const Reading> readings, const LandmarkTable& map, const GlobalPoseSearch& search,
    const PoseRegion& region, std::uint64_t max_tree_nodes = PoseSearchOptions{}.max_tree_nodes);

/// Poses of three bearings, or of three out of four, by the interpretation tree: many, and nothing verifies them. For
/// seeding only, where interpretReadings has too few detections; empty with more than four bearings or more than
/// kLargestTreeMap landmarks.
[[nodiscard]] HypothesisSet interpretThreeBearings(std::span<const Reading> readings, const LandmarkTable& map,
                                                   const GlobalPoseSearch& search, const PoseRegion& region);
}  // namespace mrpt_ext
