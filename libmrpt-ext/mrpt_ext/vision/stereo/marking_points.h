#pragma once

#include <cmath>
#include <vector>

#include "mrpt_ext/vision/stereo/stereo_camera.h"

namespace mrpt_ext
{
/// When a bright stripe counts as a marking of the field, and a step as the foot of a wall.
struct MarkingSettings
{
  double line_width = 0.003;    ///< [m] of a marking
  double max_range = 0.7;       ///< [m] on the floor; beyond it markings are thinner than can be seen
  double min_contrast = 0.15;   ///< of a stripe against the floor, share of the image's white
  double min_significance = 5;  ///< likewise, in standard deviations of the image's noise
  double wall_contrast = 0.4;   ///< of a wall against the floor, share of the image's white
  double wall_height = 0.05;    ///< [m]
  double std_line = 0.3;        ///< [px] of a marking's middle line, beyond the scatter of its points
};

/// A point of a marking's middle line or of a wall's foot.
struct MarkingPoint
{
  Eigen::Vector2d position{0, 0};                ///< [m] (forward, left) of the camera's foot
  Eigen::Vector2d along_a{0, 0}, along_b{0, 0};  ///< unit, the directions along the floor between which the line runs
  Eigen::Vector2d footprint{0, 0};               ///< [m] forward and left of one pixel here
  cv::Point2d pixel;
};

/// [m] that a footprint extends along a direction on the floor, and across it.
[[nodiscard]] inline double pixelAlong(const Eigen::Vector2d& footprint, const Eigen::Vector2d& direction)
{
  return std::abs(direction.x()) * footprint.x() + std::abs(direction.y()) * footprint.y();
}
[[nodiscard]] inline double pixelAcross(const Eigen::Vector2d& footprint, const Eigen::Vector2d& direction)
{
  return std::abs(direction.x()) * footprint.y() + std::abs(direction.y()) * footprint.x();
}

struct MarkingPoints
{
  std::vector<MarkingPoint> stripes, walls;
};

/// The darkest channel of a colour image, in which coloured things are dark and only white is bright; a grey image as
/// it is.
[[nodiscard]] cv::Mat whitenessOf(const cv::Mat& image);

/// Points of markings as double edges of opposite gradient no farther apart than a marking is wide there, along rows
/// and along columns, and the feet of white walls: in every column, from below, the first step to a bright area wider
/// than a marking. The direction follows from the gradients, to within what noise allows.
[[nodiscard]] MarkingPoints findMarkingPoints(const cv::Mat& whiteness, const StereoCamera& camera,
                                              const MarkingSettings& settings);
}  // namespace mrpt_ext
