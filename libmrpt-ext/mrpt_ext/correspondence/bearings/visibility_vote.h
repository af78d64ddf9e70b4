#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/bearings/visibility_grid.h"
#include "mrpt_ext/correspondence/scan_bearing.h"
#include "mrpt_ext/geometry/gaussian_pose.h"
#include "mrpt_ext/geometry/work_budget.h"

namespace mrpt_ext
{
constexpr int kMostOutliers = 7;  ///< bearings without a landmark that a vote can count

/// A small box of sensor poses that may have inliers: a cell and a bin of headings.
struct PoseBox
{
  std::uint32_t cell = 0;
  std::uint16_t heading = 0;  ///< bin
  std::uint16_t inliers = 0;  ///< upper bound over the poses of the box
};

/// The boxes of poses that survive a vote, by the number of inliers that they may have.
struct PoseBoxes
{
  std::vector<std::vector<PoseBox>> by_inliers;
  int floor = 0;         ///< boxes that may have at least so many inliers are all here, if every cell was counted
  bool finished = true;  ///< false: the budget ended before the cells
};

/// Rotations [bins] of a ring whose union covers the gate of a bearing.
[[nodiscard]] std::vector<int> ringRotations(const ScanBearing& bearing, double gate);

/// Votes of the bearings of one scan for every cell and heading (Hough transform over a grid of poses): per box the
/// number of bearings without a landmark in their gate, for all headings at once, in bit slices (one addition of 64
/// headings per instruction and counter bit, more with vector registers). No pose in the area is missed: every
/// bearing within `gate` standard deviations of a landmark counts as inlier. At most kMostOutliers bearings, and no
/// more than all but `floor`, may be outliers; when more than `capacity` boxes survive, the floor rises.
[[nodiscard]] PoseBoxes voteForPoses(const VisibilityGrid& index, std::span<const ScanBearing> bearings, double gate,
                                     int floor, std::size_t capacity, WorkBudget& budget);

/// The pose in the middle of a box, with a covariance of which `gate` standard deviations cover the box.
[[nodiscard]] GaussianPose poseOf(const PoseBox& hit, const VisibilityGrid& index, double gate);
}  // namespace mrpt_ext
