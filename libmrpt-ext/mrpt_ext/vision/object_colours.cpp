#include "mrpt_ext/vision/object_colours.h"

#include <algorithm>
#include <cmath>

namespace mrpt_ext
{
namespace
{
using LevelTable = std::array<float, 256>;

LevelTable makeLinear()
{
  LevelTable levels{};
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    const double v = static_cast<double>(i) / 255;
    levels[i] = static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
  }
  return levels;
}

LevelTable scaled(const LevelTable& levels, double factor)
{
  LevelTable result{};
  std::transform(levels.begin(), levels.end(), result.begin(),
                 [factor](float v) { return static_cast<float>(v * factor); });
  return result;
}

/// Hue on a scale of six sectors.
struct HueRange
{
  float low, high;
  explicit HueRange(const HueSector& s)
      : low(static_cast<float>(6 * s.low / kTwoPi)), high(static_cast<float>(6 * s.high / kTwoPi))
  {
  }
  [[nodiscard]] bool holds(float hue) const { return (hue >= low && hue < high) || (hue - 6 >= low && hue - 6 < high); }
};

/// Hue in [0, 6) of a colour with max > min.
float hueOf(float b, float g, float r, float max, float min)
{
  const float range = max - min;
  if (max == r) return g >= b ? (g - b) / range : 6 + (g - b) / range;
  if (max == g) return 2 + (b - r) / range;
  return 4 + (r - g) / range;
}
}  // namespace

const std::array<float, 256>& linearLight()
{
  static const LevelTable levels = makeLinear();
  return levels;
}

cv::Vec3d whiteOf(const cv::Mat& image, double share)
{
  std::array<std::size_t, 256> counts{};
  std::array<cv::Vec3d, 256> sums{};
  const LevelTable& linear = linearLight();
  for (int row = 0; row < image.rows; ++row)
  {
    const auto* pixel = image.ptr<cv::Vec3b>(row);
    for (int column = 0; column < image.cols; ++column)
    {
      const cv::Vec3b& p = pixel[column];
      const auto darkest = std::min({p[0], p[1], p[2]});
      ++counts[darkest];
      sums[darkest] += cv::Vec3d(linear[p[0]], linear[p[1]], linear[p[2]]);
    }
  }
  const double wanted = std::max(1.0, share * static_cast<double>(image.total()));
  double taken = 0;
  cv::Vec3d sum(0, 0, 0);
  for (std::size_t level = counts.size(); level-- > 0 && taken < wanted;)
  {
    taken += static_cast<double>(counts[level]);
    sum += sums[level];
  }
  return taken > 0 ? sum / taken : cv::Vec3d(1, 1, 1);
}

cv::Mat1b classifyColours(const cv::Mat& image, const ColourModel& model, const cv::Vec3d& white)
{
  std::array<LevelTable, 3> levels;
  for (int c = 0; c < 3; ++c) levels[static_cast<std::size_t>(c)] = scaled(linearLight(), 1 / std::max(white[c], 1e-6));
  const HueRange orange(model.orange), yellow(model.yellow), blue(model.blue);
  const auto min_brightness = static_cast<float>(model.min_brightness);
  const auto max_grey = static_cast<float>(1 - model.min_saturation);
  cv::Mat1b colours(image.size(), static_cast<unsigned char>(ObjectColour::other));
  for (int row = 0; row < image.rows; ++row)
  {
    const auto* pixel = image.ptr<cv::Vec3b>(row);
    auto* colour = colours.ptr(row);
    for (int column = 0; column < image.cols; ++column)
    {
      const cv::Vec3b& p = pixel[column];
      const float b = levels[0][p[0]], g = levels[1][p[1]], r = levels[2][p[2]];
      const float max = std::max({b, g, r}), min = std::min({b, g, r});
      if (max < min_brightness || min > max_grey * max) continue;
      const float hue = hueOf(b, g, r, max, min);
      ObjectColour found = ObjectColour::other;
      if (orange.holds(hue)) found = ObjectColour::orange;
      if (yellow.holds(hue)) found = ObjectColour::yellow;
      if (blue.holds(hue)) found = ObjectColour::blue;
      colour[column] = static_cast<unsigned char>(found);
    }
  }
  return colours;
}
}  // namespace mrpt_ext
