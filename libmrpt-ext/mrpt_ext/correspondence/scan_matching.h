#pragma once

#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// A landmark as a sensor scan would see it from a supposed robot pose.
struct ExpectedLandmark
{
  std::size_t landmark = 0;
  double bearing = 0, range = 0;                    ///< [rad], [m]
  double bearing_variance = 0, range_variance = 0;  ///< that the pose's covariance adds
  bool in_view = false;                             ///< within range limit and field of scan
  double in_view_chance = 0;                        ///< the same as a probability, the pose being uncertain
};

/// The landmarks that a scan can see from the pose, and those that it could see if the pose were a little off.
[[nodiscard]] std::vector<ExpectedLandmark> expectedLandmarks(const LandmarkIndex& map, const Scan& scan,
                                                              const GaussianPose& robot);

/// Best one-to-one matching of a scan's detections, greedily by residual: per detection the position in `expected`, or
/// -1. A residual counts when it is within `gate` standard deviations of the innovation, in bearing and in range.
[[nodiscard]] std::vector<int> associate(const LandmarkIndex& map, const Scan& scan,
                                         std::span<const ExpectedLandmark> expected, double gate);

/// Log-likelihood of all detections of a scan at a pose (see pose_verification.h); `matches` as given by associate.
[[nodiscard]] double scanLogLikelihood(const LandmarkIndex& map, const Scan& scan,
                                       std::span<const ExpectedLandmark> expected, std::span<const int> matches);
}  // namespace mrpt_ext
