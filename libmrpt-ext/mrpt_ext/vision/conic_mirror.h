#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/vision/mirror_outline.h"
#include "mrpt_ext/vision/radial_edges.h"

namespace mrpt_ext
{
/// The conic-mirror camera of paper 000, section 4: it looks straight up, so azimuths in the image run
/// counter-clockwise about the robot's vertical axis, from the image's u axis towards its v axis.
struct ConicMirrorSettings
{
  cv::Size image_size;                   ///< [px]; empty: any
  double mount_yaw = 0;                  ///< [rad] azimuth of the image's u axis in the robot's frame
  std::optional<MirrorAxis> axis;        ///< without it the mirror's axis is taken for the camera's
  std::optional<AxisEllipse> usual_rim;  ///< of other images of this camera; a rim elsewhere is something else
  OutlineSettings outline;
  PolarGrid grid;
  RadialEdgeSettings edges;
};

/// What one image shows.
struct ConicMirrorView
{
  std::string problem;                   ///< why there is no measurement; empty when there may be some
  std::optional<MirrorOutline> outline;  ///< nothing with a problem
  std::optional<MirrorAxis> axis;        ///< that of the settings
  std::vector<RadialEdge> edges;         ///< azimuths in the image
  bool contradicts = false;              ///< itself or other images: the problem is that the rim is not certain
};

/// Vertical edges seen in the mirror. A wrong, empty or black image and one without a mirror, with two circles that may
/// be it, or with a rim that is not where it usually is, have a problem and no edges.
[[nodiscard]] ConicMirrorView viewConicMirror(const cv::Mat& image, const ConicMirrorSettings& settings);

/// The rim that most of these images agree on: the mirror does not move in the camera's image. Nothing when fewer than
/// three agree, or not more than half of those that show a rim.
[[nodiscard]] std::optional<AxisEllipse> usualRimOf(const std::vector<cv::Mat>& images,
                                                    const ConicMirrorSettings& settings);

/// The image in colour with the rim and the edges that were found, green where it gets brighter counter-clockwise as
/// the robot sees it, blue where darker, with their azimuths [deg] in the frame in which the u axis has `yaw` [rad].
[[nodiscard]] cv::Mat drawConicMirror(const cv::Mat& image, const ConicMirrorView& view, double yaw = 0);
}  // namespace mrpt_ext
