#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "mrpt_ext/vision/hyperbolic_mirror.h"
#include "mrpt_ext/vision/slice_profile.h"

namespace mrpt_ext
{
/// An upright object that is symmetric about its middle azimuth.
struct Silhouette
{
  double azimuth = 0;      ///< [rad] of the middle, in the image
  double std_azimuth = 0;  ///< [rad] from the scatter of the slices
  double width_ratio = 1;  ///< seen width over that of the slices
  double std_width_ratio = 0;
  int slices = 0;          ///< that agree
};

/// Middle of an object from where it ends on both sides in each slice, by colour; where `by_brightness`, by brightness
/// as well, which is sharper where colour is coarse, but fits no object that casts a shadow beside itself. Slices that
/// do not agree with the others (something in front, a background that changes) are left out; nothing when fewer than
/// `min_slices` agree. The standard deviation follows from the scatter of the slices and how far their residuals are
/// correlated.
[[nodiscard]] std::optional<Silhouette> measureSilhouette(const cv::Mat& image, const HyperbolicMirror& mirror,
                                                          double azimuth, const std::vector<SilhouetteSlice>& slices,
                                                          int min_slices, bool by_brightness);
}  // namespace mrpt_ext
