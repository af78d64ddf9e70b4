#pragma once

#include "mrpt_ext/correspondence/global_pose_search.h"
#include "mrpt_ext/geometry/landmark_table.h"
#include "mrpt_ext/hypotheses/pose_region.h"
#include "mrpt_ext/localizers/closed_form_localizer.h"

namespace mrpt_ext
{
// The papers' closed forms applied to one frame. Several sightings of one landmark in a frame are averaged first. A
// single sensor's offset on the robot is applied exactly; closed forms that know only the robot's centre see bearings
// of several sensors as if taken there.

/// Linear least squares of paper 000 (eq 1-6) over the identified bearings.
[[nodiscard]] ClosedFormAnswer bearingLeastSquares(const Frame& frame, const LandmarkTable& map);

/// Maximum likelihood over the identified bearings, each sensor in its place (identified_pose): every pose that is
/// nearly as likely as the best. Also with status `degenerate` or `none`, which tell that it cannot be trusted.
[[nodiscard]] ClosedFormAnswer bearingMaximumLikelihood(const Frame& frame, const LandmarkTable& map);

/// Least squares over identified ranges: position only, heading unknown. Two places with two ranges or collinear
/// landmarks; those outside the region are dropped.
[[nodiscard]] ClosedFormAnswer rangeLeastSquares(const Frame& frame, const LandmarkTable& map,
                                                 const PoseRegion& region);

/// Rigid fit of two or more identified landmarks seen as points (paper 001, both poles).
[[nodiscard]] ClosedFormAnswer twoLandmarkPose(const Frame& frame, const LandmarkTable& map);

/// Search over the unidentified detections of a frame (paper 000 sec. 3, at any scale: global_pose_search.h): all
/// consistent poses in the region. `search` must be of `map`.
[[nodiscard]] ClosedFormAnswer interpretationTree(const Frame& frame, const LandmarkTable& map,
                                                  const GlobalPoseSearch& search, const PoseRegion& region);
}  // namespace mrpt_ext
