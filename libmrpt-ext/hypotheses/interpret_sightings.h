#pragma once

#include <span>

#include "mrpt_ext/hypotheses/landmark_sighting.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"
#include "mrpt_ext/hypotheses/pose_region.h"
#include "mrpt_ext/correspondence/interpretation_tree.h"

namespace mrpt_ext
{
/// Interpretation tree (paper 000 sec. 3) over the unidentified bearings of one sensor place, that with most of them:
/// all robot poses in the region from which they can be explained, with the interpretations' log-likelihoods as scores.
/// The gate is 3.3 standard deviations of the bearings; up to a third of them, at most two, may show no landmark.
struct SightingInterpretations
{
  SolveStatus status = SolveStatus::too_few;
  HypothesisSet hypotheses;  ///< robot poses, likeliest first
};

/// `allow_three`: accept three bearings, whose many poses nothing verifies (for seeding, not for an estimate).
[[nodiscard]] SightingInterpretations interpretSightings(std::span<const LandmarkSighting> sightings,
                                                         const LandmarkTable& map, const PoseRegion& region,
                                                         bool allow_three);
}  // namespace mrpt_ext
