#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "mrpt_ext/geometry/angle.h"
#include "mrpt_ext/vision/axis_ellipse.h"

namespace mrpt_ext::testing
{
/// A sector of the mirror's image: from this azimuth on to that of the next one, in
/// one grey level.
struct Sector
{
  double azimuth_deg = 0;
  double brightness = 0;
};

inline double brightnessTowards(const std::vector<Sector>& sectors, double azimuth)
{
  double brightness = sectors.back().brightness;  // the last one reaches over the end of the turn
  for (const Sector& sector : sectors)
    if (azimuth >= degToRad(sector.azimuth_deg)) brightness = sector.brightness;
  return brightness;
}

/// A mirror image drawn from its definition, without any optics.
struct MirrorPicture
{
  cv::Size size{640, 480};
  AxisEllipse rim{{322.3, 238.6}, 228.0, 215.0};
  double background = 10;
  std::vector<Sector> sectors{{-170, 200}, {-120, 90}, {-60, 180}, {-20, 120}, {35, 210}, {80, 60}, {140, 150}};
  double shading = 0;  ///< [grey levels] amplitude of one smooth wave around the turn
  double noise = 3;    ///< [grey levels]

  [[nodiscard]] double brightnessAt(double u, double v) const
  {
    const double x = (u - rim.centre.x) / rim.semi_u, y = (v - rim.centre.y) / rim.semi_v;
    if (std::hypot(x, y) > 1) return background;
    const double azimuth = std::atan2(y, x);
    return brightnessTowards(sectors, azimuth) + shading * std::sin(azimuth);
  }
};

/// 8-bit grey, every pixel the mean light of 4 x 4 samples, slightly blurred, noise from `seed`.
template <typename Picture>
cv::Mat paint(const Picture& picture, double noise_level, int seed)
{
  constexpr int kSamples = 4;
  constexpr double kCoding = 2.2;  // levels are coded light, and light is what a pixel sums
  cv::Mat image(picture.size, CV_32F);
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u)
    {
      double sum = 0;
      for (int i = 0; i < kSamples * kSamples; ++i)
        sum += std::pow(
            picture.brightnessAt(u + (i % kSamples + 0.5) / kSamples - 0.5, v + (i / kSamples + 0.5) / kSamples - 0.5),
            kCoding);
      image.at<float>(v, u) = static_cast<float>(std::pow(sum / (kSamples * kSamples), 1 / kCoding));
    }
  cv::GaussianBlur(image, image, {0, 0}, 0.6);
  cv::Mat noise(picture.size, CV_32F);
  cv::RNG random(static_cast<std::uint64_t>(seed));
  random.fill(noise, cv::RNG::NORMAL, 0, noise_level);
  image += noise;
  image.convertTo(image, CV_8U);
  return image;
}

inline cv::Mat paint(const MirrorPicture& picture, int seed = 1) { return paint(picture, picture.noise, seed); }
}  // namespace mrpt_ext::testing
