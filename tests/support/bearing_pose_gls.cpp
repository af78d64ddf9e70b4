#include "bearing_pose_gls.h"

#include <Eigen/LU>
#include <algorithm>
#include <optional>

#include "mrpt_ext/solvers/bearing_pose_linear.h"
#include "mrpt_ext/solvers/plane.h"

namespace mrpt_ext
{
namespace
{
/// The constraint that one bearing, relative to that of landmark 0, puts on f = 1 / (L_0 - R): f = r a - b', a line in
/// the plane of complex numbers (paper 000, eq 2-3).
struct BearingLine
{
  Vector2d a{0, 0};
  Vector2d b{0, 0};       ///< b' = 1 / (L_i - L_0)
  Vector2d normal{0, 0};  ///< unit normal of a
  double std = 1;         ///< of bearing i [rad]
};

/// One line per landmark except landmark 0. Requires checkBearings(...) == ok.
std::vector<BearingLine> bearingLines(std::span<const KnownBearing> bearings)
{
  std::vector<BearingLine> lines;
  lines.reserve(bearings.size());
  for (const KnownBearing& seen : bearings.subspan(1))
  {
    const Vector2d to_landmark = seen.landmark - bearings[0].landmark;
    BearingLine line;
    line.b = Vector2d(to_landmark.x(), -to_landmark.y()) / to_landmark.squaredNorm();
    const Vector2d along = rotation(seen.bearing - bearings[0].bearing) * line.b.normalized();
    line.a = along * line.b.norm();
    line.normal = perpendicular(along);
    line.std = seen.std;
    lines.push_back(line);
  }
  return lines;
}

/// r_i = |L_i - R| / |L_0 - R| on each line at f; <= 0 when the landmark would be behind its bearing.
std::vector<double> rangeRatios(std::span<const BearingLine> lines, const Vector2d& f)
{
  std::vector<double> ratios;
  ratios.reserve(lines.size());
  for (const BearingLine& line : lines) ratios.push_back(line.a.dot(f + line.b) / line.a.squaredNorm());
  return ratios;
}

/// R - L_0 = -1/f; nothing for f = 0 (landmark 0 infinitely far away).
std::optional<Vector2d> robotFromReference(const Vector2d& f)
{
  const Vector2d robot = Vector2d(-f.x(), f.y()) / f.squaredNorm();
  if (!robot.allFinite()) return std::nullopt;
  return robot;
}

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
