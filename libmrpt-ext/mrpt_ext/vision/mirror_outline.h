#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "mrpt_ext/vision/axis_ellipse.h"

namespace mrpt_ext
{
/// What is known beforehand about the mirror's rim in the image.
struct OutlineSettings
{
  double min_radius = 0.25, max_radius = 0.75;  ///< of the rim, as shares of the image's shorter side
  double min_aspect = 0.80, max_aspect = 1.25;  ///< width over height of the rim in the image (fx/fy)
  double min_visible_share = 0.4;               ///< of the rim's circumference that must be found
  double min_contrast = 5;                      ///< [grey levels] across the rim, in smoothed pixels
};

/// The mirror's rim as found in one image.
struct MirrorOutline
{
  AxisEllipse rim;
  double std_centre = 0;             ///< [px] of either coordinate of its centre
  double std_aspect = 0;             ///< of semi_u / semi_v
  double visible_share = 0;          ///< of the circumference where it was found
  std::vector<cv::Point2d> support;  ///< the points it was fitted to
};

/// Finds the rim of a rotationally symmetric mirror that the camera sees along its axis (paper 000, section 4: its
/// centre is the origin of all azimuths), from the image alone. `grey` has 8 bits.
///
/// Coarse place by votes along the image gradients (mirror_votes.h), then the strongest steps of brightness across the
/// suspected rim, of which a fixed sequence of random fours proposes ellipses; the one with most support is refined.
/// Works with dark and bright surroundings and with parts of the rim hidden or outside the image. Nothing when too
/// little of a rim is found.
[[nodiscard]] std::optional<MirrorOutline> findMirrorOutline(const cv::Mat& grey, const OutlineSettings& settings);
}  // namespace mrpt_ext
