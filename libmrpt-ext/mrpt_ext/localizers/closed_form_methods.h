#pragma once

#include "mrpt_ext/correspondence/global_pose_search.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/hypotheses/pose_region.h"
#include "mrpt_ext/localizers/closed_form_localizer.h"

namespace mrpt_ext
{
// The closed forms of the papers for one frame. Repeated measurements of a landmark are averaged first. The pose of a
// single sensor on the robot is modelled exactly; with several sensors, closed forms without sensor poses treat all
// bearings as taken at the robot's centre.

/// Linear least squares of paper 000 (eq 1-6) over the identified bearings.
[[nodiscard]] ClosedFormResult bearingLeastSquares(const Frame& frame, const LandmarkTable& map);

/// Maximum likelihood over the identified bearings, with all sensor poses (pose_from_landmarks.h): every pose nearly as
/// likely as the best one. Poses with status `degenerate` or `none` are returned too.
[[nodiscard]] ClosedFormResult bearingMaximumLikelihood(const Frame& frame, const LandmarkTable& map);

/// Least squares over identified ranges: position only, heading unknown. Two solutions with two ranges or collinear
/// landmarks; those outside the region are dropped.
[[nodiscard]] ClosedFormResult rangeLeastSquares(const Frame& frame, const LandmarkTable& map,
                                                 const PoseRegion& region);

/// Rigid fit of two or more identified landmarks with range and bearing (paper 001, both poles).
[[nodiscard]] ClosedFormResult twoLandmarkPose(const Frame& frame, const LandmarkTable& map);

/// Pose search over the anonymous detections of a frame (paper 000 sec. 3, for maps of any size: global_pose_search.h):
/// all consistent poses in the region. `search` must be of `map`.
[[nodiscard]] ClosedFormResult interpretationTree(const Frame& frame, const LandmarkTable& map,
                                                  const GlobalPoseSearch& search, const PoseRegion& region);
}  // namespace mrpt_ext
