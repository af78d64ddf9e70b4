#pragma once

#include <vector>

#include "mrpt_ext/solvers/pose_residuals.h"

namespace mrpt_ext
{
/// A pose from a minimal subset of the measurements, scored on all of them.
struct PoseGuess
{
  Pose2 pose;
  double rough_cost = 0;  ///< PoseResiduals::roughCost
};

/// Poses from minimal subsets of the measurements, best first, at most `most`: triples of bearings
/// (three_bearing_pose.h, or three_bearing_pose_noncentral.h for sensors at different positions), the rigid fit of
/// landmarks seen with range and bearing, and crossings of circles and lines (ranges, pairs of bearings, bearings under
/// a known heading) with the mean of the headings that the bearings then imply. The subsets are spread evenly over
/// the measurements, some tens of them. For ranges alone, twelve headings are tried.
[[nodiscard]] std::vector<PoseGuess> solveMinimalSubsets(const PoseResiduals& rows, std::size_t most);
}  // namespace mrpt_ext
