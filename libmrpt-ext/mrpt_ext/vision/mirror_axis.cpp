#include "mrpt_ext/vision/mirror_axis.h"

#include <cmath>

#include "mrpt_ext/geometry/angle.h"

namespace mrpt_ext
{
cv::Point2d centreOfAzimuths(const AxisEllipse& rim, const std::optional<MirrorAxis>& axis, double share)
{
  if (!axis) return rim.centre;
  const double slope = std::tan(axis->cone_half_angle), rim_slope = std::tan(axis->rim_angle);
  const double ray_slope = share * rim_slope, ray = std::atan(ray_slope);
  const double elevation = kPi / 2 - 2 * axis->cone_half_angle + ray;
  const double rim_height = (slope - ray_slope) / (slope - rim_slope);  // of the rim, in heights at this radius
  const double factor = rim_height * (1 - std::sin(ray) / std::cos(elevation));
  return axis->principal_point + factor * (rim.centre - axis->principal_point);
}
}  // namespace mrpt_ext
