#pragma once

#include <opencv2/core/types.hpp>
#include <optional>

#include "mrpt_ext/vision/axis_ellipse.h"

namespace mrpt_ext
{
/// Parameters of a conic mirror whose axis is beside the camera's: its rim is then not around the principal point.
struct MirrorAxis
{
  cv::Point2d principal_point;  ///< [px] of the camera
  double cone_half_angle = 0;   ///< [rad] of the mirror, apex towards the camera
  double rim_angle = 0;         ///< [rad] between the camera's axis and the ray to the rim, < cone_half_angle
};

/// The centre of azimuths at the radius `share` of the rim's: its centre when the axes agree (no
/// `axis`).
///
/// A ray that leaves the camera o beside the mirror's axis keeps its tangential part when it is reflected. To first
/// order in o, image points of one azimuth at the angle phi to the camera's axis are around f o (1 - sin(phi) / cos(e))
/// / z(phi), with the reflected ray's elevation e = 90 deg - 2 alpha + phi and the mirror's height z above the pinhole;
/// the rim's centre is at f o / z(rim). So edges of the room are no straight lines, but circles of the image can be
/// moved until they are.
[[nodiscard]] cv::Point2d centreOfAzimuths(const AxisEllipse& rim, const std::optional<MirrorAxis>& axis, double share);
}  // namespace mrpt_ext
