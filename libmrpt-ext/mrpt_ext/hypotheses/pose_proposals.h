#pragma once

#include <optional>
#include <span>

#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/hypotheses/landmark_measurement.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"
#include "mrpt_ext/solvers/running_fix_pose.h"

namespace mrpt_ext
{
// Proposals from minimal subsets of one type of measurement, not scored and possibly wrong; propose_poses.h ranks them.

/// The heading of the compass; without one, `points` headings around the circle.
[[nodiscard]] std::vector<HeadingPrior> headingsToTry(const std::optional<CompassRecord>& compass, std::size_t points);

/// Pairs of landmarks with range and bearing: rigid fit of every pair.
[[nodiscard]] HypothesisSet proposeFromPointPairs(std::span<const LandmarkMeasurement> measurements);

/// Triples of bearings to different landmarks: closed form of paper 000, refined.
[[nodiscard]] HypothesisSet proposeFromBearings(std::span<const LandmarkMeasurement> measurements);

/// Ranges to two or more landmarks: position by trilateration. The heading follows from a bearing, from the motion
/// within the window, or is unknown.
[[nodiscard]] HypothesisSet proposeFromRanges(std::span<const LandmarkMeasurement> measurements);

/// Landmarks with range and bearing that face a known direction: the pose that each gives by itself, or two.
[[nodiscard]] HypothesisSet proposeFromFacing(std::span<const LandmarkMeasurement> measurements);

/// One landmark with range and bearing: `points` poses on the ring around it.
[[nodiscard]] HypothesisSet proposeFromRing(std::span<const LandmarkMeasurement> measurements, std::size_t points);

/// Running fixes: two candidates each with the heading of the compass; without a compass, for each of `points`
/// headings.
[[nodiscard]] HypothesisSet proposeFromRunningFixes(const Frame& frame, const LandmarkTable& map, std::size_t points);
}  // namespace mrpt_ext
