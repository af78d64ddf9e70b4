#include "mrpt_ext/solvers/bearing_pose_from_units.h"

#include <algorithm>
#include <cmath>

#include "mrpt_ext/solvers/bearing_pose_linear.h"

namespace mrpt_ext
{
namespace
{
/// Landmark i against landmark 0. `a` is a_i |v|^2, which has the length of v = L_i - L_0.
struct Leg
{
  double vx, vy, ax, ay;
};

inline Leg legOf(const UnitBearing& bearing, const UnitBearing& reference)
{
  const double vx = bearing.landmark.x() - reference.landmark.x(), vy = bearing.landmark.y() - reference.landmark.y();
  const double ux = bearing.unit.x(), uy = bearing.unit.y(), wx = reference.unit.x(), wy = reference.unit.y();
  const double c = ux * wx + uy * wy, s = uy * wx - ux * wy;
  return {vx, vy, c * vx + s * vy, s * vx - c * vy};
}

/// Sums over the legs: S f = -v.
struct NormalEquations
{
  double sxx = 0, sxy = 0, syy = 0;
  double vx = 0, vy = 0;
};

inline NormalEquations sumUp(std::span<const UnitBearing> bearings)
{
  NormalEquations sum;
  for (std::size_t i = 1; i < bearings.size(); ++i)
  {
    const Leg leg = legOf(bearings[i], bearings[0]);
    const double scale = 1 / (leg.vx * leg.vx + leg.vy * leg.vy);
    // The normal of a is (-ay, ax); b' = (vx, -vy) |v|^-2.
    const double offset = -(leg.ay * leg.vx + leg.ax * leg.vy) * scale * scale;
    sum.sxx += leg.ay * leg.ay * scale;
    sum.sxy -= leg.ax * leg.ay * scale;
    sum.syy += leg.ax * leg.ax * scale;
    sum.vx -= leg.ay * offset;
    sum.vy += leg.ax * offset;
  }
  return sum;
}

/// r_i > 0 for every landmark: none lies behind its bearing.
inline bool allAhead(std::span<const UnitBearing> bearings, double fx, double fy)
{
  bool ahead = true;
  for (std::size_t i = 1; i < bearings.size(); ++i)
  {
    const Leg leg = legOf(bearings[i], bearings[0]);
    const double v2 = leg.vx * leg.vx + leg.vy * leg.vy;
    ahead &= leg.ax * (fx * v2 + leg.vx) + leg.ay * (fy * v2 - leg.vy) > 0;
  }
  return ahead;
}
}  // namespace

BearingPoseFromUnits solveBearingPoseFromUnits(std::span<const UnitBearing> bearings)
{
  BearingPoseFromUnits result;
  if (bearings.size() < 3) return result;
  result.status = SolveStatus::degenerate;

  const NormalEquations sum = sumUp(bearings);
  const double determinant = sum.sxx * sum.syy - sum.sxy * sum.sxy;
  const double legs = static_cast<double>(bearings.size() - 1);
  const double quality = determinant / (legs * legs);
  if (!std::isfinite(quality)) return result;
  result.quality = std::max(0.0, quality);
  if (quality < kSingularBearingRatio) return result;

  const double fx = (sum.sxy * sum.vy - sum.syy * sum.vx) / determinant;
  const double fy = (sum.sxy * sum.vx - sum.sxx * sum.vy) / determinant;
  const double f2 = fx * fx + fy * fy;
  if (!(f2 > 0) || !std::isfinite(1 / f2)) return result;
  if (!allAhead(bearings, fx, fy))
  {
    result.status = SolveStatus::behind;
    return result;
  }

  // L_0 - R = 1 / f; its direction is that of the conjugate of f.
  const Vector2d& unit = bearings[0].unit;
  const double inverse = 1 / std::sqrt(f2);
  const double ex = fx * inverse, ey = -fy * inverse;
  result.status = SolveStatus::ok;
  result.position = bearings[0].landmark - inverse * Vector2d(ex, ey);
  result.heading = {ex * unit.x() + ey * unit.y(), ey * unit.x() - ex * unit.y()};
  return result;
}
}  // namespace mrpt_ext
