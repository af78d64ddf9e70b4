#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "mrpt_ext/vision/axis_ellipse.h"
#include "mrpt_ext/vision/outline_settings.h"

namespace mrpt_ext
{
/// The mirror's rim as found in one image.
struct MirrorOutline
{
  AxisEllipse rim;
  double std_centre = 0;             ///< [px] of either coordinate of its centre
  double std_aspect = 0;             ///< of semi_u / semi_v
  double visible_share = 0;          ///< of the circumference where it was found, less what chance finds
  std::vector<cv::Point2d> support;  ///< the points it was fitted to
  std::optional<AxisEllipse> rival;  ///< another circle with nearly as much of a rim, about another centre
};

/// Finds the rim of a rotationally symmetric mirror that the camera sees along its axis (paper 000, section 4: its
/// centre is the origin of all azimuths), from the image alone. `grey` has 8 bits.
///
/// Coarse positions by votes along the image gradients (mirror_votes.h), then RANSAC on the strongest steps of
/// brightness across the suspected rim: samples of four steps, from a fixed seed, propose ellipses, and the one with
/// the most inliers is refined.
/// Works with dark and bright surroundings and with parts of the rim hidden or outside the image. Nothing when too
/// little of a rim is found.
[[nodiscard]] std::optional<MirrorOutline> findMirrorOutline(const cv::Mat& grey, const OutlineSettings& settings);
}  // namespace mrpt_ext
