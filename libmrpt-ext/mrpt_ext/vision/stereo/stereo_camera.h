#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <optional>

namespace mrpt_ext
{
/// A rectified pair of cameras side by side, level but for a common pitch. Pixel centres are at integers. Places are
/// (forward, left) [m] on the floor below the left camera (below the right one for its own image), axes as the robot's.
struct StereoCamera
{
  cv::Size size;              ///< [px]
  double fx = 0, fy = 0;      ///< [px]
  double cx = 0, cy = 0;      ///< [px]
  double baseline = 0;        ///< [m] the right camera is that far to the right
  double height = 0;          ///< [m] above the floor
  double pitch = 0;           ///< [rad] positive: looking down
  bool whole_pixels = false;  ///< disparities are rounded, as in paper 004

  /// [px] of what is `depth` [m] away along the optical axis.
  [[nodiscard]] double disparityAt(double depth) const { return fx * baseline / depth; }
  /// Where the ray of a pixel meets the floor; nothing at or above the horizon.
  [[nodiscard]] std::optional<Eigen::Vector2d> floorAt(const cv::Point2d& pixel) const;
  /// [m] of floor, along and across the line of sight, that a pixel covers at a position.
  [[nodiscard]] Eigen::Vector2d footprintAt(const Eigen::Vector2d& position) const
  {
    const double range = position.norm();
    return {range * range / (height * fy), range / fx};
  }
  /// The pixel of a point at `height_above_floor` [m]; nothing behind the camera.
  [[nodiscard]] std::optional<cv::Point2d> pixelOf(const Eigen::Vector2d& position,
                                                   double height_above_floor = 0) const;
  /// Columns per row along an upright edge through this pixel: with a pitch, upright edges meet in a point.
  [[nodiscard]] double uprightSlope(const cv::Point2d& pixel) const;
};

/// Measurement from a pair of pixels: range in the floor plane from the left camera and bearing from the forward axis.
struct StereoMeasurement
{
  double range = 0, std_range = 0;      ///< [m]
  double bearing = 0, std_bearing = 0;  ///< [rad] CCW
  double depth = 0;                     ///< [m] along the optical axis
  Eigen::Vector2d position{0, 0};       ///< [m] (forward, left) of the left camera
};

/// The standard deviation of the range grows with its square, as that of the depth f B / disparity does; the bearing
/// does not depend on the disparity (paper 004, section 4; the horizontal distance, with the pitch taken off, where the
/// paper takes the depth). Nothing without a positive disparity.
[[nodiscard]] std::optional<StereoMeasurement> measureStereo(const StereoCamera& camera, const cv::Point2d& left,
                                                             double disparity, double std_u, double std_disparity);
}  // namespace mrpt_ext
