#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
/// The colours that objects of the field have.
enum class ObjectColour : unsigned char
{
  other,
  orange,
  yellow,
  blue
};

/// Sector of hue [rad], counter-clockwise from `low` to `high`; red is 0, green 120 degrees, blue 240 degrees.
struct HueSector
{
  double low = 0, high = 0;
};

/// What makes a pixel orange, yellow or blue: its hue in linear light after white balance. Brightness hardly matters,
/// so shading, distance of the lamps and exposure do not.
struct ColourModel
{
  HueSector orange{degToRad(-10.0), degToRad(33.0)};
  HueSector yellow{degToRad(33.0), degToRad(80.0)};
  HueSector blue{degToRad(200.0), degToRad(265.0)};
  double min_saturation = 0.55;    ///< 1 - darkest / brightest channel
  double min_brightness = 0.02;    ///< of the brightest channel, share of white
  double white_share = 0.03;       ///< of the pixels; these, brightest in all three channels, are taken for white
  std::optional<cv::Vec3d> white;  ///< linear BGR of white [1 = grey level 255]; nothing: from each image itself
};

/// Linear light of the 256 grey levels of a camera that codes as sRGB does, [0, 1].
[[nodiscard]] const std::array<float, 256>& linearLight();

/// Linear BGR of what is white in a BGR image: mean of the pixels that are brightest in their darkest channel. Coloured
/// things, however bright, have a dark channel.
[[nodiscard]] cv::Vec3d whiteOf(const cv::Mat& image, double share);

/// ObjectColour of every pixel of a BGR image.
[[nodiscard]] cv::Mat1b classifyColours(const cv::Mat& image, const ColourModel& model, const cv::Vec3d& white);
}  // namespace mrpt_ext
