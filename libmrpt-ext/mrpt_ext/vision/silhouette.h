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
  double azimuth = 0;          ///< [rad] of the middle, in the image
  double std_azimuth = 0;      ///< [rad]
  double width_ratio = 1;      ///< seen width over that of the slices
  double std_width_ratio = 0;  ///< of the slices alone
  int slices = 0;              ///< that agree
};

/// Middle of an object, given roughly, from where it ends on both sides in each slice: least squares over all slices,
/// by colour and, of an object that casts no shadow beside itself, by brightness as well, which is sharper where colour
/// is coarse (JPEG). Slices that do not agree with the others (something in front, a background that changes) are left
/// out; nothing when fewer than `min_slices` agree. Standard deviations follow from the scatter of the slices, their
/// noise and the correlation of their residuals.
[[nodiscard]] std::optional<Silhouette> measureSilhouette(const cv::Mat& image, const HyperbolicMirror& mirror,
                                                          double azimuth, const std::vector<SilhouetteSlice>& slices,
                                                          int min_slices, bool casts_shadow);

/// One edge of an object of which something hides the other side.
struct VisibleEdge
{
  double azimuth = 0, std_azimuth = 0;  ///< [rad] in the image
};

/// The edge on one side (-1 at smaller azimuths, 1 at larger ones) of what is seen of such an object; `slices` have the
/// width of the part that is seen, roughly, and `azimuth` is its middle. By colour and brightness as above.
[[nodiscard]] std::optional<VisibleEdge> measureEdge(const cv::Mat& image, const HyperbolicMirror& mirror,
                                                     double azimuth, const std::vector<SilhouetteSlice>& slices,
                                                     int min_slices, int side);
}  // namespace mrpt_ext
