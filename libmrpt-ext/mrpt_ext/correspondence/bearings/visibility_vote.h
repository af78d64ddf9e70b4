#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/bearings/visibility_grid.h"
#include "mrpt_ext/correspondence/scan_bearing.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
constexpr int kMostOutliers = 7;  ///< bearings without landmark that a scan can count

/// A small box of sensor poses that may explain bearings: a cell and a bin of headings.
struct PoseBox
{
  std::uint32_t cell = 0;
  std::uint16_t heading = 0;  ///< bin
  std::uint16_t inliers = 0;  ///< no pose in the box explains more bearings
};

/// The boxes of poses that survive a scan, by the number of bearings that they may explain.
struct PoseBoxes
{
  std::vector<std::vector<PoseBox>> by_inliers;
  int floor = 0;  ///< boxes that explain at least so many are all here
};

/// Rotations [bins] of a ring whose union holds what a reading could point to.
[[nodiscard]] std::vector<int> ringRotations(const ScanBearing& reading, double gate);

/// Compares the bearings of one scan with every cell under every heading: box by box, the number of bearings that have
/// no landmark anywhere they could point to is counted for all headings at once, in bit slices (one addition of 64
/// headings per instruction and counter bit, more with vector registers). Nothing is missed by a pose in the area:
/// every reading within `gate` standard deviations of a landmark counts as inliers. At most kMostOutliers
/// bearings, and no more than all but `floor`, may be without landmark; when more than `capacity` boxes survive, the
/// floor rises.
[[nodiscard]] PoseBoxes voteForPoses(const VisibilityGrid& index, std::span<const ScanBearing> bearings, double gate,
                                     int floor, std::size_t capacity);

/// The pose in the middle of a box, with a covariance of which `gate` standard deviations schedule the box.
[[nodiscard]] GaussianPose poseOf(const PoseBox& hit, const VisibilityGrid& index, double gate);
}  // namespace mrpt_ext
