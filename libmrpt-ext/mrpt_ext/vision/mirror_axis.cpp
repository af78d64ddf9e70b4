#include "mrpt_ext/vision/mirror_axis.h"

#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
namespace
{
/// [px] of a length in shares of the rim's radius.
cv::Point2d inPixels(const AxisEllipse& rim, const cv::Point2d& share)
{
  return {rim.semi_u * share.x, rim.semi_v * share.y};
}
}  // namespace

CentreShifts centreShifts(double cone_half_angle, double rim_angle, double share)
{
  const double slope = std::tan(cone_half_angle), rim_slope = std::tan(rim_angle);
  const double ray_slope = share * rim_slope, ray = std::atan(ray_slope);
  const double elevation = kPi / 2 - 2 * cone_half_angle + ray;
  const double rim_height = (slope - ray_slope) / (slope - rim_slope);  // of the rim, in heights at this radius
  return {rim_height * (1 - std::sin(ray) / std::cos(elevation)) - 1, -rim_slope, share * std::tan(elevation)};
}

cv::Point2d mirrorOffset(const AxisEllipse& rim, const MirrorAxis& axis)
{
  const double slope = std::tan(axis.rim_angle);
  return rim.centre - axis.principal_point - inPixels(rim, (1 / slope + slope) * axis.camera_tilt);
}

cv::Point2d centreOfAzimuths(const AxisEllipse& rim, const std::optional<MirrorAxis>& axis, double share)
{
  if (!axis) return rim.centre;
  const CentreShifts shifts = centreShifts(axis->cone_half_angle, axis->rim_angle, share);
  return rim.centre + shifts.by_offset * mirrorOffset(rim, *axis) +
         inPixels(rim, shifts.by_camera_tilt * axis->camera_tilt + shifts.by_vertical_tilt * axis->vertical_tilt);
}
}  // namespace mrpt_ext
