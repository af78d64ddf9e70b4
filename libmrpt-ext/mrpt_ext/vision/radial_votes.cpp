#include "mrpt_ext/vision/radial_votes.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "mrpt_ext/geometry/quantile.h"

namespace mrpt_ext
{
namespace
{
constexpr float kFullVote = 3;           ///< of one row, in standard deviations of its noise
constexpr float kExcessShare = 0.05F;    ///< what is above counts little, only to leave peaks of strong edges sharp
constexpr float kVoteThreshold = 0.7F;   ///< a row below it is evidence against the edge
constexpr float kRoundingNoise = 0.15F;  ///< [grey levels] that rounding leaves even in a perfect image
constexpr int kNoiseStride = 4;          ///< every fourth column is enough for a median

/// Derivative of a Gaussian, each half summing to 1.
cv::Mat stepKernel(double sigma)
{
  const int reach = std::max(1, static_cast<int>(std::ceil(3 * sigma)));
  cv::Mat kernel(1, 2 * reach + 1, CV_32F);
  double half = 0;
  for (int i = 1; i <= reach; ++i) half += i * std::exp(-i * i / (2 * sigma * sigma));
  for (int i = -reach; i <= reach; ++i)
    kernel.at<float>(0, i + reach) = static_cast<float>(i * std::exp(-i * i / (2 * sigma * sigma)) / half);
  return kernel;
}

float noiseOf(const cv::Mat& row)
{
  std::vector<float> sizes;
  const float* const values = row.ptr<float>();
  for (int j = 0; j < row.cols; j += kNoiseStride) sizes.push_back(std::abs(values[j]));
  return std::max(kRoundingNoise, static_cast<float>(upperMedian(std::move(sizes)) / kNormalMedianDeviation));
}
}  // namespace

AzimuthSteps stepsAlongAzimuth(const PolarImage& polar, double smoothing)
{
  const cv::Mat kernel = stepKernel(smoothing / polar.grid.azimuthStep());
  const int reach = kernel.cols / 2;
  cv::Mat padded;
  cv::copyMakeBorder(polar.grey, padded, 0, 0, reach, reach, cv::BORDER_WRAP);
  cv::filter2D(padded, padded, CV_32F, kernel, {-1, -1}, 0, cv::BORDER_REPLICATE);
  AzimuthSteps steps{padded.colRange(reach, reach + polar.grey.cols).clone(), {}};
  steps.heights.setTo(0, polar.inside == 0);
  for (int row = 0; row < steps.heights.rows; ++row) steps.noise.push_back(noiseOf(steps.heights.row(row)));
  return steps;
}

std::vector<RadialRun> strongestRuns(const AzimuthSteps& steps, int polarity)
{
  const std::size_t columns = static_cast<std::size_t>(steps.heights.cols);
  std::vector<RadialRun> best(columns);
  std::vector<float> sum(columns, 0.F);
  std::vector<int> first(columns, 0);
  for (int row = 0; row < steps.heights.rows; ++row)
  {
    const float scale = static_cast<float>(polarity) / steps.noise[static_cast<std::size_t>(row)];
    const float* const heights = steps.heights.ptr<float>(row);
    for (std::size_t j = 0; j < columns; ++j)
    {
      const float vote = scale * heights[j], clipped = std::clamp(vote, -kFullVote, kFullVote);
      if (sum[j] <= 0) sum[j] = 0, first[j] = row;
      sum[j] += clipped + kExcessShare * (vote - clipped) - kVoteThreshold;
      if (sum[j] > best[j].evidence) best[j] = {sum[j], first[j], row + 1};
    }
  }
  return best;
}
}  // namespace mrpt_ext
