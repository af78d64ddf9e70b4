#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mrpt_ext/correspondence/landmark_index.h"
#include "mrpt_ext/correspondence/scan.h"
#include "mrpt_ext/geometry/gaussian_pose.h"

namespace mrpt_ext
{
/// Predicted measurement of a landmark from a hypothetical robot pose.
struct ExpectedLandmark
{
  std::size_t landmark = 0;
  double bearing = 0, range = 0;                    ///< [rad], [m]
  double bearing_variance = 0, range_variance = 0;  ///< added by the covariance of the pose
  bool in_view = false;                             ///< within range limit and field of view
  double visibility = 0;                            ///< probability of being in view, over the uncertainty of the pose
};

/// Operations (work_budget.h) of expectedLandmarks() and associate(): for so many landmarks, and with a precise pose.
[[nodiscard]] std::uint64_t costOfMatching(std::size_t expected, std::size_t detections);
[[nodiscard]] std::uint64_t costOfMatching(const LandmarkIndex& map, const Scan& scan);

/// The landmarks in view of a scan from the pose, and those that would be in view from nearby poses.
[[nodiscard]] std::vector<ExpectedLandmark> expectedLandmarks(const LandmarkIndex& map, const Scan& scan,
                                                              const GaussianPose& robot);

/// One-to-one association of the detections of a scan, greedily by residual: per detection the index in `expected`,
/// or -1. Residuals count up to `gate` standard deviations of the innovation, in bearing and in range.
[[nodiscard]] std::vector<int> associate(const LandmarkIndex& map, const Scan& scan,
                                         std::span<const ExpectedLandmark> expected, double gate);

/// Log-likelihood of all detections of a scan at a pose (formula: pose_verification.h); `matches` as returned by
/// associate().
[[nodiscard]] double scanLogLikelihood(const LandmarkIndex& map, const Scan& scan,
                                       std::span<const ExpectedLandmark> expected, std::span<const int> matches);
}  // namespace mrpt_ext
