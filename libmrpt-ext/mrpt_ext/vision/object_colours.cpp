#include "mrpt_ext/vision/object_colours.h"

#include <algorithm>
#include <cmath>
#include <vector>

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
  /// 1 or 0.
  [[nodiscard]] int holds(float hue) const { return within(hue) | within(hue - 6); }
  [[nodiscard]] int within(float hue) const { return static_cast<int>(hue >= low) & static_cast<int>(hue < high); }
};

/// Hue in [0, 6) of a colour; 0 for grey.
float hueOf(float b, float g, float r, float max, float min)
{
  const float range = std::max(max - min, 1e-9F);
  const float of_red = (g - b) / range, of_green = 2 + (b - r) / range, of_blue = 4 + (r - g) / range;
  const float from_red = of_red < 0 ? 6 + of_red : of_red;
  return max == r ? from_red : (max == g ? of_green : of_blue);
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
  const auto for_all = [&image](const auto& use)
  {
    for (int row = 0; row < image.rows; ++row)
      for (const auto *pixel = image.ptr<cv::Vec3b>(row), *end = pixel + image.cols; pixel != end; ++pixel)
        use(*pixel, std::min({(*pixel)[0], (*pixel)[1], (*pixel)[2]}));
  };
  for_all([&](const cv::Vec3b&, unsigned char darkest) { ++counts[darkest]; });
  const double wanted = std::max(1.0, share * static_cast<double>(image.total()));
  std::size_t least = counts.size();
  double taken = 0;
  while (least > 0 && taken < wanted) taken += static_cast<double>(counts[--least]);
  if (!(taken > 0)) return {1, 1, 1};
  cv::Vec3d sum(0, 0, 0);
  const LevelTable& linear = linearLight();
  for_all(
      [&](const cv::Vec3b& p, unsigned char darkest)
      {
        if (darkest >= least) sum += cv::Vec3d(linear[p[0]], linear[p[1]], linear[p[2]]);
      });
  return sum / taken;
}

cv::Mat1b classifyColours(const cv::Mat& image, const ColourModel& model, const cv::Vec3d& white)
{
  std::array<LevelTable, 3> levels;
  for (int c = 0; c < 3; ++c) levels[static_cast<std::size_t>(c)] = scaled(linearLight(), 1 / std::max(white[c], 1e-6));
  const HueRange orange(model.orange), yellow(model.yellow), blue(model.blue);
  const auto min_brightness = static_cast<float>(model.min_brightness);
  const auto max_grey = static_cast<float>(1 - model.min_saturation);
  const auto columns = static_cast<std::size_t>(image.cols);
  std::vector<float> bs(columns), gs(columns), rs(columns);
  cv::Mat1b colours(image.size());
  for (int row = 0; row < image.rows; ++row)
  {
    const auto* pixel = image.ptr<cv::Vec3b>(row);
    for (std::size_t i = 0; i < columns; ++i)
      bs[i] = levels[0][pixel[i][0]], gs[i] = levels[1][pixel[i][1]], rs[i] = levels[2][pixel[i][2]];
    auto* colour = colours.ptr(row);
    for (std::size_t i = 0; i < columns; ++i)  // without branches, so that several pixels are done at once
    {
      const float b = bs[i], g = gs[i], r = rs[i];
      const float max = std::max(std::max(b, g), r), min = std::min(std::min(b, g), r);
      const float hue = hueOf(b, g, r, max, min);
      const int by_hue = std::max({static_cast<int>(ObjectColour::orange) * orange.holds(hue),
                                   static_cast<int>(ObjectColour::yellow) * yellow.holds(hue),
                                   static_cast<int>(ObjectColour::blue) * blue.holds(hue)});
      const int is_coloured = static_cast<int>(max >= min_brightness) & static_cast<int>(min <= max_grey * max);
      colour[i] = static_cast<unsigned char>(is_coloured * by_hue);
    }
  }
  return colours;
}
}  // namespace mrpt_ext
