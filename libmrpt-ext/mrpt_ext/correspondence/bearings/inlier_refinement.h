#pragma once

#include <span>

#include "mrpt_ext/correspondence/bearings/inlier_bound.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
struct RefinedPose
{
  GaussianPose sensor;
  int inliers = 0;         ///< bearings with a landmark within the gate of the refined pose
  bool refined = false;    ///< false: the bearings that only one landmark can explain do not fix a pose
  bool plausible = false;  ///< before it was refined the pose inliers enough
};

/// Refines a sensor pose that comes from few bearings on those that it explains, in a few rounds: first on the few
/// bearings that only one landmark can explain and that are predicted best, then, with the smaller gates that result,
/// on all that are inliers. Gives up when fewer than `least` are. `scratch` saves allocations. About a microsecond:
/// it stands between the sieve and the full judgement.
[[nodiscard]] RefinedPose refineOnInliers(const GaussianPose& sensor, std::span<const BoundingScan> scans, double gate,
                                          int least, GatedLandmarks& scratch);
}  // namespace mrpt_ext
