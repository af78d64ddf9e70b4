#pragma once

#include <optional>
#include <span>

#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"

namespace mrpt_ext
{
/// Poses from the identified detections of joined readings (oldest first), each landmark brought to one point in the
/// robot frame first (window_landmark.h): the running fix of paper 004 for any number and mix of bearings and ranges.
/// Two landmarks or more: the rigid fit of every pair, all mirror images, as far as they fit (source
/// `joined_landmarks`). One landmark: its ring (source `joined_ring`), `points` poses for every place it may have, or,
/// with a compass, one; mirror images are separate rings. Nothing where no landmark is held.
[[nodiscard]] HypothesisSet proposeFromWindowLandmarks(std::span<const Reading> oldest_first, const LandmarkTable& map,
                                                       const std::optional<CompassRecord>& compass, std::size_t points);

/// A pose refined on all identified detections of joined readings, with the errors of odometry shared
/// (window_pose.h): its covariance may be believed, that of a refinement on single grown deviations may not. Readings
/// that a pose does not explain within four deviations are left aside as false: of `start`, then of the refined one.
/// Nothing when they hold no pose.
[[nodiscard]] std::optional<GaussianPose> refineOnWindow(std::span<const Reading> oldest_first,
                                                         const LandmarkTable& map, const Pose2& start);
}  // namespace mrpt_ext
