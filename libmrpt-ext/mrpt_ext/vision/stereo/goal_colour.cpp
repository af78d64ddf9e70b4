#include "mrpt_ext/vision/stereo/goal_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mrpt_ext/vision/stereo/edge_mixture.h"

namespace mrpt_ext
{
namespace
{
constexpr float kLeastBrightness = 0.4F, kMostBrightness = 1.3F;  ///< of the bright channel, share of the white's
constexpr float kHueTolerance = 0.5F;                             ///< of six: 30 degrees
constexpr float kLeastSaturation = 0.5F;                          ///< 1 - darkest / brightest share, in linear light
constexpr float kLeastShade = 0.04F;    ///< of the white's level, that a wall in the shade is darker
constexpr float kMostShade = 0.6F;      ///< likewise
constexpr float kSameShade = 0.1F;      ///< shares of the channels agree by so much: white in the shade is white
constexpr int kStepGap = 2, kMean = 3;  ///< [px] from the step to where a side's level begins, and pixels averaged
constexpr double kWhiteQuantile = 0.9;  ///< of the pixels are darker than the image's white
constexpr float kWhiteShare = 0.45F;    ///< of it is still white, in the shade
constexpr float kLeastShare = 0.25F;    ///< of the white's level the dark channel must fall by

/// Of the pixels that the row has.
cv::Vec3f meanOf(const cv::Vec3b* pixels, int columns, int first, int count)
{
  const int begin = std::max(first, 0), end = std::min(first + count, columns);
  cv::Vec3f sum(0, 0, 0);
  for (int i = begin; i < end; ++i) sum += cv::Vec3f(pixels[i]);
  return sum * (1.F / static_cast<float>(end - begin));
}

/// Each channel as a share of the white's.
cv::Vec3f sharesOf(const cv::Vec3f& white, const cv::Vec3f& colour)
{
  cv::Vec3f shares;
  for (int channel = 0; channel < 3; ++channel) shares[channel] = colour[channel] / std::max(1.F, white[channel]);
  return shares;
}

struct HueAndSaturation
{
  float hue = 0;  ///< of six: red 0, green 2, blue 4
  float saturation = 0;
};

/// Of shares of white as coded, whose squares are nearly linear light, at any gain.
HueAndSaturation colourOf(const cv::Vec3f& shares)
{
  const float b = shares[0] * shares[0], g = shares[1] * shares[1], r = shares[2] * shares[2];
  const float max = std::max({b, g, r}), min = std::min({b, g, r}), range = max - min;
  if (!(range > 0)) return {};
  const float hue = max == r ? (g - b) / range : max == g ? 2 + (b - r) / range : 4 + (r - g) / range;
  return {hue, range / max};
}

float brightnessOf(const cv::Vec3f& colour) { return 0.114F * colour[0] + 0.587F * colour[1] + 0.299F * colour[2]; }

/// Of some pixels between white and paint, given the linear light of both.
PaintInShade shadeIn(const cv::Vec3b* pixels, int count, const cv::Vec3d& white, const cv::Vec3d& paint)
{
  const EdgeMixture mixture(white, paint);
  const double of_paint = brightnessOf(paint);
  PaintInShade shade;
  shade.contrast = brightnessOf(white) - of_paint;
  for (int i = 0; i < count; ++i)
  {
    const cv::Vec3d light = lightOf(pixels[i]);
    const double is_white = mixture.whiteIn(light), missing = mixture.darkIn(light) * of_paint;
    shade.of_white += is_white * missing, shade.of_paint += (1 - is_white) * missing;
  }
  return shade;
}

/// Whether `dark` is the same white in the shade: all channels fall alike.
bool isShadeOf(const cv::Vec3f& white, const cv::Vec3f& dark)
{
  const cv::Vec3f shares = sharesOf(white, dark);
  const float max = std::max({shares[0], shares[1], shares[2]}), min = std::min({shares[0], shares[1], shares[2]});
  return max < 1 - kLeastShade && min > 1 - kMostShade && max - min < kSameShade;
}
}  // namespace

GoalColour::GoalColour(const cv::Vec3f& shares)
{
  for (int channel = 0; channel < 3; ++channel)
  {
    if (shares[channel] < shares[dark_]) dark_ = channel;
    if (shares[channel] > shares[bright_]) bright_ = channel;
  }
  hue_ = colourOf(shares).hue;
}

bool GoalColour::matches(const cv::Vec3f& white, const cv::Vec3f& colour) const
{
  const cv::Vec3f shares = sharesOf(white, colour);
  if (shares[bright_] < kLeastBrightness || shares[bright_] > kMostBrightness) return false;
  const auto [hue, saturation] = colourOf(shares);
  if (saturation < kLeastSaturation) return false;
  const float apart = std::abs(hue - hue_);
  return std::min(apart, 6 - apart) < kHueTolerance;
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

double PaintInShade::shift() const { return std::max(0.0, of_paint - std::abs(of_white)) / contrast; }

PaintInShade& PaintInShade::operator+=(const PaintInShade& other)
{
  of_paint += other.of_paint, of_white += other.of_white, contrast += other.contrast;
  return *this;
}

cv::Vec3f meanAround(const cv::Mat& bgr, int row, int column)
{
  return meanOf(bgr.ptr<cv::Vec3b>(row), bgr.cols, column - kMean / 2, kMean);
}

std::optional<BrightnessStep> brightnessStepAt(const cv::Mat& bgr, int row, double column, int side)
{
  const cv::Vec3b* const pixels = bgr.ptr<cv::Vec3b>(row);
  const int reach = kStepGap + kMean, u = static_cast<int>(std::floor(column));
  if (u - reach + 1 < 0 || u + reach >= bgr.cols) return std::nullopt;
  const cv::Vec3f left = meanOf(pixels, bgr.cols, u - reach + 1, kMean),
                  right = meanOf(pixels, bgr.cols, u + kStepGap + 1, kMean);
  const cv::Vec3d white = lightOf(side > 0 ? left : right), paint = lightOf(side > 0 ? right : left);
  const float half = 0.5F * (brightnessOf(left) + brightnessOf(right));
  if (brightnessOf(white) <= brightnessOf(paint)) return std::nullopt;
  for (const int i : {u, u - 1, u + 1})
  {
    const float a = brightnessOf(pixels[i]) - half, b = brightnessOf(pixels[i + 1]) - half;
    if (static_cast<float>(side) * a >= 0 && static_cast<float>(side) * b < 0)
      return BrightnessStep{i + static_cast<double>(a / (a - b)),
                            shadeIn(pixels + u - kStepGap + 1, 2 * kStepGap, white, paint)};
  }
  return std::nullopt;
}

std::vector<double> stepsInRow(const cv::Mat& bgr, int row, int first_column, int last_column, const ColourStep& step,
                               const cv::Vec3f& least_white)
{
  const int gap = step.colour ? kStepGap : 1, reach = gap + (step.colour ? kMean : 2);
  const int first = std::max(first_column, kStepGap), last = std::min(last_column, bgr.cols - 1 - kStepGap);
  std::vector<double> columns;
  if (row < 0 || row >= bgr.rows) return columns;
  const cv::Vec3b* const pixels = bgr.ptr<cv::Vec3b>(row);
  const int channel = step.colour ? step.colour->darkChannel() : 1, side = step.side;
  const auto level = [&](int u) { return static_cast<float>(pixels[u][channel]); };
  // How much darker it gets towards the colour across the boundary between u and u + 1.
  const auto fall = [&](int u)
  { return static_cast<float>(side) * (level(u) + level(u - 1) - level(u + 1) - level(u + 2)); };
  const auto is_step = [&](const cv::Vec3f& white, const cv::Vec3f& dyed)
  {
    if (!isWhite(white, least_white)) return false;
    if (!step.colour) return isShadeOf(white, dyed);
    return white[channel] - dyed[channel] >= kLeastShare * white[channel] && step.colour->matches(white, dyed);
  };
  for (int u = first; u < last; ++u)
  {
    const float here = fall(u);
    if (here <= 0 || here < fall(u - 1) || here <= fall(u + 1)) continue;
    cv::Vec3f left = meanOf(pixels, bgr.cols, u - reach + 1, reach - gap),
              right = meanOf(pixels, bgr.cols, u + gap + 1, reach - gap);
    const cv::Vec3f &white = side > 0 ? left : right, &dyed = side > 0 ? right : left;
    if (!is_step(white, dyed)) continue;
    std::optional<EdgeMixture> mixture;  // shade has no colour
    if (step.colour) mixture.emplace(lightOf(white), lightOf(dyed));
    const double half = 0.5F * (white[channel] + dyed[channel]);
    const auto beyond_half = [&](int i)
    { return side * (mixture ? mixture->whiteIn(lightOf(pixels[i])) - 0.5 : level(i) - half); };
    for (int i = u - 1; i <= u + 1; ++i)
    {
      const double a = beyond_half(i), b = beyond_half(i + 1);
      if (a < 0 || b >= 0) continue;
      columns.push_back(i + a / (a - b));
      break;
    }
  }
  return columns;
}
}  // namespace mrpt_ext
