#pragma once

#include <cmath>
#include <string>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Warning about a landmark (or its beacon): "few inliers" below an inlier rate of 0.7, "biased" when the mean residual
/// of the inliers exceeds one standard deviation, "noisier than declared" when their residuals scatter by more than
/// twice the declared standard deviation. Empty without a reason.
[[nodiscard]] inline std::string landmarkWarning(const LandmarkScore& landmark)
{
  if (landmark.inlier_rate && *landmark.inlier_rate < 0.7) return "few inliers";
  if (landmark.residual_mean && std::abs(*landmark.residual_mean) > 1) return "biased";
  if (landmark.residual_std && *landmark.residual_std > 2) return "noisier than declared";
  return {};
}
}  // namespace mrpt_ext
