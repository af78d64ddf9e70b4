#include "mrpt_ext/solvers/bearing_pose_gls.h"

#include <Eigen/LU>
#include <algorithm>

#include "mrpt_ext/solvers/bearing_lines.h"
#include "mrpt_ext/solvers/bearing_pose_linear.h"
#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
/// One solve with the weights that belong to `f`; nothing when they make the system singular.
std::optional<Vector2d> reweighted(std::span<const BearingLine> lines, double reference_std, const Vector2d& f)
{
  Matrix2d A = Matrix2d::Zero();
  Vector2d v = Vector2d::Zero(), sum_m = Vector2d::Zero();
  double sum_c = 0, sum_w = 1 / square(reference_std);
  for (const BearingLine& line : lines)
  {
    // A robot on landmark i would make g vanish and its weight infinite.
    const double g = std::max((f + line.b).norm(), 1e-9 * line.b.norm());
    const double w = 1 / square(line.std);
    const Vector2d m = line.normal / g;
    const double c = line.normal.dot(line.b) / g;
    A += w * m * m.transpose();
    v += w * m * c;
    sum_m += w * m;
    sum_c += w * c;
    sum_w += w;
  }
  A -= sum_m * sum_m.transpose() / sum_w;
  v -= sum_m * sum_c / sum_w;
  const double size = square(0.5 * A.trace());
  if (!(A.determinant() > 1e-14 * size)) return std::nullopt;
  return Vector2d(-A.inverse() * v);
}
}  // namespace

BearingPoseGls solveBearingPoseGls(std::span<const KnownBearing> bearings, int iterations)
{
  const BearingPoseLinear seed = solveBearingPoseLinear(bearings);
  BearingPoseGls result;
  result.status = seed.status;
  result.det_ratio = seed.det_ratio;
  result.f = seed.f;
  if (seed.status != SolveStatus::ok && seed.status != SolveStatus::behind) return result;

  const std::vector<BearingLine> lines = bearingLines(bearings);
  result.status = SolveStatus::degenerate;
  for (int k = 0; k < iterations; ++k)
  {
    const std::optional<Vector2d> f = reweighted(lines, bearings[0].std, result.f);
    if (!f) return result;
    result.f = *f;
  }
  const std::optional<Vector2d> from_reference = robotFromReference(result.f);
  if (!from_reference) return result;
  const std::vector<double> r = rangeRatios(lines, result.f);
  result.status = SolveStatus::behind;
  if (std::any_of(r.begin(), r.end(), [](double ratio) { return ratio <= 0; })) return result;

  const Vector2d position = bearings[0].landmark + *from_reference;
  result.status = SolveStatus::ok;
  result.pose = {position.x(), position.y(), meanHeading(bearings, position)};
  result.residuals = bearingResiduals(bearings, result.pose);
  return result;
}
}  // namespace mrpt_ext
