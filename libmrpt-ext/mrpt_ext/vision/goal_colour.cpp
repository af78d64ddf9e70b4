#include "mrpt_ext/vision/goal_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mrpt_ext
{
namespace
{
constexpr float kLeastBrightness = 0.4F, kMostBrightness = 1.3F;  ///< of the bright channel, share of the white's
constexpr float kMiddleFactor = 2;      ///< the middle channel may differ from the model by this factor
constexpr int kStepGap = 2, kMean = 3;  ///< [px] from the step to where a side's level begins, and pixels averaged
constexpr double kWhiteQuantile = 0.9;  ///< of the pixels are darker than the image's white
constexpr float kWhiteShare = 0.45F;    ///< of it is still white, in the shade
constexpr float kLeastShare = 0.25F;    ///< of the white's level the dark channel must fall by

/// Of the pixels that the row has.
cv::Vec3f meanOf(const cv::Vec3b* pixels, int columns, int first)
{
  const int begin = std::max(first, 0), end = std::min(first + kMean, columns);
  cv::Vec3f sum(0, 0, 0);
  for (int i = begin; i < end; ++i) sum += cv::Vec3f(pixels[i]);
  return sum * (1.F / static_cast<float>(end - begin));
}
}  // namespace

GoalColour::GoalColour(const cv::Vec3f& shares)
{
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int b) { return shares[a] < shares[b]; });
  dark_ = order[0], middle_ = order[1], bright_ = order[2];
  dark_limit_ = std::sqrt(shares[dark_] / shares[bright_]);
  middle_least_ = shares[middle_] / shares[bright_] / kMiddleFactor;
  middle_most_ = shares[middle_] / shares[bright_] * kMiddleFactor;
}

bool GoalColour::matches(const cv::Vec3f& white, const cv::Vec3f& colour) const
{
  const auto share = [&](int channel) { return colour[channel] / std::max(1.F, white[channel]); };
  const float bright = share(bright_);
  if (bright < kLeastBrightness || bright > kMostBrightness || share(dark_) > dark_limit_ * bright) return false;
  const float middle = share(middle_) / bright;
  return middle > middle_least_ && middle < middle_most_;
}

cv::Vec3f leastWhite(const cv::Mat& bgr, int step)
{
  std::array<std::array<int, 256>, 3> counts{};
  int total = 0;
  for (int row = step / 2; row < bgr.rows; row += step)
    for (int column = step / 2; column < bgr.cols; column += step, ++total)
      for (int channel = 0; channel < 3; ++channel)
        ++counts[static_cast<std::size_t>(channel)][bgr.at<cv::Vec3b>(row, column)[channel]];
  cv::Vec3f least;
  for (int channel = 0; channel < 3; ++channel)
  {
    int value = 255;
    double brighter = 0;
    while (value > 0 && (brighter += counts[static_cast<std::size_t>(channel)][static_cast<std::size_t>(value)]) <
                            (1 - kWhiteQuantile) * total)
      --value;
    least[channel] = kWhiteShare * static_cast<float>(value);
  }
  return least;
}

cv::Vec3f meanAround(const cv::Mat& bgr, int row, int column)
{
  return meanOf(bgr.ptr<cv::Vec3b>(row), bgr.cols, column - kMean / 2);
}

std::vector<double> colourStepsInRow(const cv::Mat& bgr, int row, int first_column, int last_column,
                                     const GoalColour& colour, int side, const cv::Vec3f& least_white)
{
  constexpr int kReach = kStepGap + kMean;
  const int first = std::max(first_column, kStepGap), last = std::min(last_column, bgr.cols - 1 - kStepGap);
  std::vector<double> columns;
  if (row < 0 || row >= bgr.rows) return columns;
  const cv::Vec3b* const pixels = bgr.ptr<cv::Vec3b>(row);
  const int channel = colour.darkChannel();
  const auto level = [&](int u) { return static_cast<float>(pixels[u][channel]); };
  // How much darker it gets towards the colour across the boundary between u and u + 1.
  const auto fall = [&](int u)
  { return static_cast<float>(side) * (level(u) + level(u - 1) - level(u + 1) - level(u + 2)); };
  for (int u = first; u < last; ++u)
  {
    const float here = fall(u);
    if (here <= 0 || here < fall(u - 1) || here <= fall(u + 1)) continue;
    cv::Vec3f left = meanOf(pixels, bgr.cols, u - kReach + 1), right = meanOf(pixels, bgr.cols, u + kStepGap + 1);
    const cv::Vec3f &white = side > 0 ? left : right, &dyed = side > 0 ? right : left;
    if (!isWhite(white, least_white)) continue;
    if (white[channel] - dyed[channel] < kLeastShare * white[channel] || !colour.matches(white, dyed)) continue;
    const float half = 0.5F * (white[channel] + dyed[channel]);
    for (int i = u - 1; i <= u + 1; ++i)
    {
      const float a = level(i) - half, b = level(i + 1) - half;
      if (static_cast<float>(side) * a < 0 || static_cast<float>(side) * b >= 0) continue;
      columns.push_back(i + static_cast<double>(a / (a - b)));
      break;
    }
  }
  return columns;
}
}  // namespace mrpt_ext
