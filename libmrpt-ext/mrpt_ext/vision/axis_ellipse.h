#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <optional>
#include <vector>

namespace mrpt_ext
{
/// An ellipse with axes parallel to those of the image: a circle seen along its axis by a camera with non-square
/// pixels. Pixel centres at integers.
struct AxisEllipse
{
  cv::Point2d centre;
  double semi_u = 0, semi_v = 0;  ///< [px]

  /// Width over height of the pixels' image of a circle: fx/fy of the camera.
  [[nodiscard]] double aspect() const { return semi_u / semi_v; }
  /// Point at the angle of the undistorted circle, at `share` of its radius.
  [[nodiscard]] cv::Point2d at(const cv::Point2d& direction, double share = 1) const
  {
    return {centre.x + share * semi_u * direction.x, centre.y + share * semi_v * direction.y};
  }
  /// Distance from `p` to the ellipse, positive outside, to first order [px].
  [[nodiscard]] double distance(const cv::Point2d& p) const;
};

/// An ellipse fitted to points, with its covariance.
struct EllipseFit
{
  AxisEllipse ellipse;
  double rms = 0;                                        ///< [px] of the points' distances
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< of (centre u, centre v, semi_u, semi_v) [px^2]
};

/// Through exactly four points or, in the least-squares sense of the conic u^2 + B v^2 + C u + D v + E = 0, near more
/// of them. Nothing when they are on no ellipse.
[[nodiscard]] std::optional<AxisEllipse> ellipseThrough(const std::vector<cv::Point2d>& points);

/// Smallest sum of squared distances, starting from `start` (Gauss-Newton). Nothing with fewer than five points or a
/// degenerate position of the points.
[[nodiscard]] std::optional<EllipseFit> refineEllipse(const AxisEllipse& start, const std::vector<cv::Point2d>& points);
}  // namespace mrpt_ext
