#pragma once

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

/// An upright object that is symmetric about its middle azimuth.
struct Silhouette
{
  double azimuth = 0;      ///< [rad] of the middle, in the image
  double std_azimuth = 0;  ///< [rad] from the scatter of the slices
  double width_ratio = 1;  ///< seen width over that of the slices
  int slices = 0;          ///< that agree
};

/// Middle of an object from where it ends on both sides in each slice. Every pixel of a slice is a mixture of the
/// object's colour, at whatever brightness, and the background's colour beside it, in linear light; the shares of the
/// background, summed outwards from the middle, locate the edges to fractions of a pixel, whatever the shading of a
/// round object. Slices that do not agree with the others (something in front, a background that changes) are left out;
/// nothing when fewer than `min_slices` agree.
[[nodiscard]] std::optional<Silhouette> measureSilhouette(const cv::Mat& image, const HyperbolicMirror& mirror,
                                                          double azimuth, const std::vector<SilhouetteSlice>& slices,
                                                          int min_slices);
}  // namespace mrpt_ext
