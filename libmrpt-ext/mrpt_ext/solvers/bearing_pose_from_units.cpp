#include "mrpt_ext/solvers/bearing_pose_from_units.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/solvers/bearing_pose_linear.h"

namespace mrpt_ext
{
namespace
{
/// Least squares for k: of every bearing the row (q, p) with right side s, all divided by |v_i|, where v_i = L_i - L_0,
/// p + j q = conj(u_i) v_i and s = cross(u_0, u_i).
struct NormalEquations
{
  double sxx = 0, sxy = 0, syy = 0;
  double bx = 0, by = 0;
};

[[gnu::always_inline]] inline NormalEquations sumUp(std::span<const UnitBearing> bearings)
{
  const Vector2d &origin = bearings[0].landmark, &reference = bearings[0].unit;
  NormalEquations sum;
  for (std::size_t i = 1; i < bearings.size(); ++i)
  {
    const Vector2d &landmark = bearings[i].landmark, &unit = bearings[i].unit;
    const double vx = landmark.x() - origin.x(), vy = landmark.y() - origin.y();
    const double p = unit.x() * vx + unit.y() * vy, q = unit.x() * vy - unit.y() * vx;
    const double s = unit.y() * reference.x() - unit.x() * reference.y();
    const double scale = 1 / (p * p + q * q);
    const double sp = p * scale, sq = q * scale;
    sum.sxx += q * sq;
    sum.sxy += q * sp;
    sum.syy += p * sp;
    sum.bx += s * sq;
    sum.by += s * sp;
  }
  return sum;
}

/// r_i > 0 for every landmark: none lies behind its bearing. r_i / r_0 = Re(conj(u_i) (v_i k + u_0)), here with
/// n = d k, d > 0.
[[gnu::always_inline]] inline bool allAhead(std::span<const UnitBearing> bearings, double nx, double ny, double d)
{
  const Vector2d &origin = bearings[0].landmark, &reference = bearings[0].unit;
  const double wx = d * reference.x(), wy = d * reference.y();
  int behind = 0;
  for (std::size_t i = 1; i < bearings.size(); ++i)
  {
    const Vector2d &landmark = bearings[i].landmark, &unit = bearings[i].unit;
    const double vx = landmark.x() - origin.x(), vy = landmark.y() - origin.y();
    const double along = unit.x() * (vx * nx - vy * ny + wx) + unit.y() * (vx * ny + vy * nx + wy);
    behind |= along > 0 ? 0 : 1;
  }
  return behind == 0;
}
}  // namespace

MRPT_EXT_VECTOR_CLONES
BearingPoseFromUnits solveBearingPoseFromUnits(std::span<const UnitBearing> bearings)
{
  BearingPoseFromUnits result;
  if (bearings.size() < 3) return result;
  result.status = SolveStatus::degenerate;

  const NormalEquations sum = sumUp(bearings);
  const double d = sum.sxx * sum.syy - sum.sxy * sum.sxy;
  const double nx = sum.syy * sum.bx - sum.sxy * sum.by, ny = sum.sxx * sum.by - sum.sxy * sum.bx;  // k = n / d
  const double n2 = nx * nx + ny * ny;
  const double legs = static_cast<double>(bearings.size() - 1), most = legs * legs;
  if (!std::isfinite(d)) return result;
  result.quality = std::max(0.0, d / most);
  if (d < kSingularBearingRatio * most || !(n2 > 0) || !std::isfinite(n2)) return result;
  result.status = SolveStatus::behind;
  if (!allAhead(bearings, nx, ny, d)) return result;

  const double inverse = 1 / std::sqrt(n2), distance = d * inverse;
  const double hx = nx * inverse, hy = -ny * inverse;
  const Vector2d &landmark = bearings[0].landmark, &unit = bearings[0].unit;
  result.status = SolveStatus::ok;
  result.heading = {hx, hy};
  result.position = {landmark.x() - distance * (hx * unit.x() - hy * unit.y()),
                     landmark.y() - distance * (hx * unit.y() + hy * unit.x())};
  return result;
}
}  // namespace mrpt_ext
