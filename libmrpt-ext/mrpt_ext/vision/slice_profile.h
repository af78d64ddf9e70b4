#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "mrpt_ext/vision/hyperbolic_mirror.h"

namespace mrpt_ext
{
/// Rows of the image of a mirror in which an object is of one colour: image radii, and half its width there.
struct SilhouetteSlice
{
  double rho_low = 0, rho_high = 0;
  double half_width = 0;  ///< [rad]
};

/// Grey levels of a slice from one side of an object to the other, a sample per pixel, as JPEG separates them:
/// brightness Y' at the image's resolution, colour Cb and Cr, which may be coarser.
struct SliceProfile
{
  double per_pixel = 0;      ///< [rad]
  double half_width = 0;     ///< [px] expected
  double first = 0;          ///< [px] of the first sample from the middle; the others follow a pixel apart
  std::vector<double> luma;  ///< Y'
  std::array<std::vector<double>, 2> chroma;  ///< Cb and Cr
  double shift_low = 0, shift_high = 0;  ///< [px] by which either edge seems nearer to the middle (`light_coding.h`)
  [[nodiscard]] std::size_t size() const { return luma.size(); }
  /// Y' between the samples; beyond them that of the last one.
  [[nodiscard]] double lumaAt(double offset) const;
};

/// Grey levels between the pixels of a BGR image; nothing outside.
[[nodiscard]] std::optional<cv::Vec3d> levelsAt(const cv::Mat& image, const cv::Point2d& position);

/// The slice around `azimuth` [rad], `reach` [px] beyond either edge; nothing where it leaves the image.
[[nodiscard]] std::optional<SliceProfile> profileOf(const cv::Mat& image, const HyperbolicMirror& mirror,
                                                    double azimuth, const SilhouetteSlice& slice, double reach);
}  // namespace mrpt_ext
