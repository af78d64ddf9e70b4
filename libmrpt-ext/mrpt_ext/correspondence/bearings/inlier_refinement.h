#pragma once

#include <cstdint>
#include <span>

#include "mrpt_ext/correspondence/bearings/inlier_bound.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
struct RefinedPose
{
  GaussianPose sensor;
  int inliers = 0;               ///< bearings with a landmark within the gate of the refined pose
  bool refined = false;          ///< false: the bearings with a single possible landmark do not determine a pose
  bool enough_at_start = false;  ///< enough inliers before the refinement
  std::uint64_t operations = 0;  ///< spent (geometry/work_budget.h)
};

/// Refines a sensor pose that comes from few bearings on its inliers, in a few rounds: first on the few bearings
/// with a single possible landmark that are predicted best, then, with the smaller gates that result, on all
/// inliers (as local optimization in RANSAC). Gives up with fewer than `least` inliers. `scratch` saves
/// allocations. About a microsecond, between the bound and the verification.
[[nodiscard]] RefinedPose refineOnInliers(const GaussianPose& sensor, std::span<const BoundingScan> scans, double gate,
                                          int least, GatedLandmarks& scratch);
}  // namespace mrpt_ext
