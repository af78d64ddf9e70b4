#pragma once

#include <vector>

#include "mrpt_ext/vision/polar_image.h"

namespace mrpt_ext
{
/// Steps of brightness along azimuth and their noise.
struct AzimuthSteps
{
  cv::Mat heights;           ///< CV_32F [grey levels], positive where it gets brighter towards growing azimuth
  std::vector<float> noise;  ///< [grey levels] standard deviation per row
};

/// Steps between the cells before and behind every cell, weighted by a Gaussian's derivative with standard deviation
/// `smoothing` [rad] so that a sharp step of height h gives a peak of h. The noise of a row is the median of its
/// absolute steps, which a few edges do not move.
[[nodiscard]] AzimuthSteps stepsAlongAzimuth(const PolarImage& polar, double smoothing);

/// The run of rows with most evidence for an edge of one polarity at one azimuth.
struct RadialRun
{
  float evidence = 0;      ///< sum of the votes above the threshold of a single vote
  int first = 0, end = 0;  ///< rows [first, end)
};

/// For every column the run with the largest sum of clipped votes, for steps of the sign of `polarity`.
[[nodiscard]] std::vector<RadialRun> strongestRuns(const AzimuthSteps& steps, int polarity);
}  // namespace mrpt_ext
