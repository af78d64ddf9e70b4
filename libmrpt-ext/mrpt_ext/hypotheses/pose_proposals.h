#pragma once

#include <optional>
#include <span>

#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/hypotheses/landmark_measurement.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"

namespace mrpt_ext
{
// Each function proposes poses from one kind of evidence, unranked and possibly wrong; propose_poses.h scores them.

/// Pairs of landmarks seen with range and bearing: rigid fit of every pair.
[[nodiscard]] HypothesisSet proposeFromPointPairs(std::span<const LandmarkMeasurement> sightings);

/// Three bearings at a time to different landmarks: closed form of paper 000, refined.
[[nodiscard]] HypothesisSet proposeFromBearings(std::span<const LandmarkMeasurement> sightings);

/// Ranges to two or more landmarks: position; the heading from a bearing, or from the way between joined readings, or
/// unknown.
[[nodiscard]] HypothesisSet proposeFromRanges(std::span<const LandmarkMeasurement> sightings);

/// One landmark with range and bearing: `points` poses around its ring.
[[nodiscard]] HypothesisSet proposeFromRing(std::span<const LandmarkMeasurement> sightings, std::size_t points);

/// Running fixes with the heading of the compass: two candidates each; without a compass, each for `points` headings.
[[nodiscard]] HypothesisSet proposeFromRunningFixes(const Frame& frame, const LandmarkTable& map, std::size_t points);
}  // namespace mrpt_ext
