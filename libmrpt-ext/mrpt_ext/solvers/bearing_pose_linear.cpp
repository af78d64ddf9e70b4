#include "mrpt_ext/solvers/bearing_pose_linear.h"

#include <Eigen/LU>
#include <algorithm>

#include "mrpt_ext/solvers/bearing_lines.h"
#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
BearingPoseLinear solveBearingPoseLinear(std::span<const KnownBearing> bearings)
{
  BearingPoseLinear result;
  result.status = checkBearings(bearings);
  if (result.status != SolveStatus::ok) return result;

  const std::vector<BearingLine> lines = bearingLines(bearings);
  Matrix2d S = Matrix2d::Zero();
  Vector2d v = Vector2d::Zero();
  for (const BearingLine& line : lines)
  {
    S += line.normal * line.normal.transpose();
    v += line.normal * line.normal.dot(line.b);
  }
  result.det_ratio = std::max(0.0, S.determinant()) / square(static_cast<double>(lines.size()));
  result.status = SolveStatus::degenerate;
  if (result.det_ratio < kSingularBearingRatio) return result;
  result.f = -S.inverse() * v;
  const std::optional<Vector2d> from_reference = robotFromReference(result.f);
  if (!from_reference) return result;

  result.r = rangeRatios(lines, result.f);
  result.status = SolveStatus::behind;
  if (std::any_of(result.r.begin(), result.r.end(), [](double r) { return r <= 0; })) return result;

  const Vector2d position = bearings[0].landmark + *from_reference;
  result.status = SolveStatus::ok;
  result.pose = {position.x(), position.y(), wrap(angleOf(-*from_reference) - bearings[0].bearing)};
  result.mean_phi = meanHeading(bearings, position);
  result.residuals = bearingResiduals(bearings, result.pose);
  return result;
}
}  // namespace mrpt_ext
