#include "mrpt_ext/solvers/heading_from_landmark.h"

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
bool hasDirection(const Vector2d& v) { return v.allFinite() && v.squaredNorm() > 0; }
}  // namespace

std::optional<double> headingFromLandmark(const Vector2d& landmark, const Vector2d& position,
                                          const Vector2d& landmark_in_robot)
{
  if (!hasDirection(landmark_in_robot)) return std::nullopt;
  return headingFromBearing(landmark, position, angleOf(landmark_in_robot));
}

std::optional<double> headingFromBearing(const Vector2d& landmark, const Vector2d& position, double bearing)
{
  const Vector2d to_landmark = landmark - position;
  if (!hasDirection(to_landmark) || !std::isfinite(bearing)) return std::nullopt;
  return wrap(angleOf(to_landmark) - bearing);
}
}  // namespace mrpt_ext
