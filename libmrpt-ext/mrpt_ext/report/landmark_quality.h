#pragma once

#include <cmath>
#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Why a landmark (or its beacon) should not be trusted: "few inliers" below an inlier rate of 0.7, "biased" when the
/// inliers are off by more than one standard deviation on average, "noisier than declared" when they scatter more
/// than twice as much as their standard deviation says. Empty: nothing speaks against it.
[[nodiscard]] inline std::string landmarkWarning(const LandmarkScore& landmark)
{
  if (landmark.inlier_rate && *landmark.inlier_rate < 0.7) return "few inliers";
  if (landmark.residual_mean && std::abs(*landmark.residual_mean) > 1) return "biased";
  if (landmark.residual_std && *landmark.residual_std > 2) return "noisier than declared";
  return {};
}
}  // namespace mrpt_ext
