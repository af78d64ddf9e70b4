#pragma once

#include <opencv2/core/types.hpp>
#include <optional>

#include "mrpt_ext/vision/axis_ellipse.h"

namespace mrpt_ext
{
/// How camera, conic mirror and robot stand to each other: a mirror whose axis is beside the camera's has its rim not
/// around the principal point. Tilts are (towards the u axis, towards the v axis).
struct MirrorAxis
{
  cv::Point2d principal_point;  ///< [px] of the camera
  double cone_half_angle = 0;   ///< [rad] of the mirror, apex towards the camera
  double rim_angle = 0;         ///< [rad] between the camera's axis and the ray to the rim, < cone_half_angle
  cv::Point2d camera_tilt;      ///< [rad] direction of the mirror's axis, seen from the camera's
  cv::Point2d vertical_tilt;    ///< [rad] direction of the vertical, seen from the mirror's axis
};

/// How far the centre of azimuths at a radius moves, in the same unit as what moves it.
struct CentreShifts
{
  double by_offset = 0;         ///< of the mirror beside the camera: per distance of their images at the rim
  double by_camera_tilt = 0;    ///< shares of the rim's radius per [rad]
  double by_vertical_tilt = 0;  ///< shares of the rim's radius per [rad]
};

/// Against the rim's centre, at the radius `share` of the rim's, to first order.
///
/// A ray that leaves the camera o beside the mirror's axis keeps its tangential part when it is reflected. Image points
/// of one azimuth at the angle phi to the camera's axis are around f o (1 - sin(phi) / cos(e)) / z(phi), with the
/// reflected ray's elevation e = 90 deg - 2 alpha + phi and the mirror's height z above the pinhole; the rim's centre
/// is at f o / z(rim). A camera that is tilted under the mirror sees circles about its axis shifted outwards by
/// tan^2(phi) of the axis' own shift, but azimuths still about the axis. The vertical of a tilted mirror moves azimuths
/// by tan(e) of the tilt. So edges of the room are no straight lines, but circles of the image can be moved until they
/// are.
[[nodiscard]] CentreShifts centreShifts(double cone_half_angle, double rim_angle, double share);

/// [px] What the rim's centre is beside the principal point because the mirror's axis is beside the camera's.
[[nodiscard]] cv::Point2d mirrorOffset(const AxisEllipse& rim, const MirrorAxis& axis);

/// The centre of azimuths at the radius `share` of the rim's: its centre when the axes agree (no `axis`).
[[nodiscard]] cv::Point2d centreOfAzimuths(const AxisEllipse& rim, const std::optional<MirrorAxis>& axis, double share);
}  // namespace mrpt_ext
