#pragma once

#include <optional>
#include <span>

#include "mrpt_ext/geometry/frame.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/hypotheses/pose_hypothesis.h"

namespace mrpt_ext
{
/// Poses from the identified detections of a window (oldest first). Each landmark is first localized in the robot frame
/// (window_landmark.h): the running fix of paper 004 for any number and mix of bearings and ranges.
/// Two landmarks or more: the rigid fit of every pair, all mirror images included, gated by its residual (source
/// `window_landmarks`). One landmark: the ring around it (source `window_ring`) sampled at `points` poses, or with a
/// compass one pose; mirror images are separate rings. Empty if no landmark can be localized.
[[nodiscard]] HypothesisSet proposeFromWindowLandmarks(std::span<const Reading> oldest_first, const LandmarkTable& map,
                                                       const std::optional<CompassRecord>& compass, std::size_t points);

/// A pose refined on all identified detections of a window, with their shared odometry errors modelled (window_pose.h):
/// unlike a refinement with independent inflated standard deviations, it gives a consistent covariance. Outliers beyond
/// four standard deviations are rejected, first for `start`, then for the refined pose. Nothing if the inliers do not
/// determine a pose.
[[nodiscard]] std::optional<GaussianPose> refineOnWindow(std::span<const Reading> oldest_first,
                                                         const LandmarkTable& map, const Pose2& start);
}  // namespace mrpt_ext
