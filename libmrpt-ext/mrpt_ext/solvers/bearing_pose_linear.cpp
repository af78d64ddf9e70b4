#include "mrpt_ext/solvers/bearing_pose_linear.h"

#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
BearingPoseLinear solveBearingPoseLinear(std::span<const KnownBearing> bearings)
{
  BearingPoseLinear result;
  result.status = checkBearings(bearings);
  if (result.status != SolveStatus::ok) return result;

  std::vector<UnitBearing> units;
  units.reserve(bearings.size());
  for (const KnownBearing& b : bearings) units.push_back({b.landmark, direction(b.bearing)});
  const BearingPoseFromUnits solution = solveBearingPoseFromUnits(units);
  result.status = solution.status;
  result.det_ratio = solution.det_ratio;
  if (solution.status != SolveStatus::ok && solution.status != SolveStatus::behind) return result;

  const auto times = [](const Vector2d& a, const Vector2d& b)
  { return Vector2d(a.x() * b.x() - a.y() * b.y(), a.x() * b.y() + a.y() * b.x()); };
  const Vector2d& reference = units[0].unit;
  result.f = times(solution.k, {reference.x(), -reference.y()});
  for (const UnitBearing& b : std::span(units).subspan(1))
    result.r.push_back(b.unit.dot(times(b.landmark - units[0].landmark, solution.k) + reference));
  if (solution.status != SolveStatus::ok) return result;

  result.pose = {solution.position.x(), solution.position.y(), angleOf(solution.heading)};
  result.mean_phi = meanHeading(bearings, solution.position);
  result.residuals = bearingResiduals(bearings, result.pose);
  return result;
}
}  // namespace mrpt_ext
