#pragma once

#include <opencv2/core/types.hpp>

namespace mrpt_ext
{
/// A camera that looks straight up into a hyperbolic mirror (paper 001): the sheet z^2/a^2 - r^2/b^2 = 1 above the
/// pinhole, which is in the outer focus. All rays pass through the inner focus, so azimuths are exact. Azimuths in the
/// image run from its u axis towards its v axis, which is counter-clockwise seen from above.
struct HyperbolicMirror
{
  double a = 0, b = 0;          ///< [m] semi-axes of the mirror, > 0
  double rim_radius = 0;        ///< [m] of the mirror
  double focus_height = 0;      ///< [m] inner focus above the floor
  double fx = 0, fy = 0;        ///< [px]
  cv::Point2d centre = {0, 0};  ///< [px] the mirror's axis in the image

  /// Pixel of the ray with this azimuth and image radius `rho` (of a camera with focal length 1).
  [[nodiscard]] cv::Point2d pixel(double azimuth, double rho) const;
  /// Mean focal length [px]: pixels per unit of `rho`.
  [[nodiscard]] double focalLength() const { return 0.5 * (fx + fy); }
  /// Image radius of the rim.
  [[nodiscard]] double rimRho() const;
  /// Image radius of rays with this slope (tangent of the elevation seen from the inner focus).
  [[nodiscard]] double rhoAt(double slope) const;
  /// The inverse of rhoAt.
  [[nodiscard]] double slopeAt(double rho) const;
  /// Slope of a point at `height` [m] above the floor and `distance` [m] > 0 from the mirror's axis.
  [[nodiscard]] double slopeOf(double height, double distance) const { return (height - focus_height) / distance; }
};
}  // namespace mrpt_ext
