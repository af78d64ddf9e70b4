#include "mrpt_ext/solvers/bearing_pose_from_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mrpt_ext/geometry/vector_clones.h"

namespace mrpt_ext
{
namespace
{
/// Per bearing what the second pass needs: conj(u_i) (L_i - L_0) = p + j q, and the cosine c against the reference. An
/// array for each, so that the second pass reads whole vectors; on the stack up to a usual number of bearings.
class Projections
{
 public:
  explicit Projections(std::size_t count)
  {
    const std::size_t stride = std::max(count, kOnStack);
    if (count > kOnStack) heap_.resize(3 * stride);
    p = count > kOnStack ? heap_.data() : stack_.data();
    q = p + stride;
    c = q + stride;
  }
  Projections(const Projections&) = delete;
  Projections& operator=(const Projections&) = delete;

  double *p, *q, *c;

 private:
  static constexpr std::size_t kOnStack = 64;
  std::array<double, 3 * kOnStack> stack_;
  std::vector<double> heap_;
};

/// Least squares for k: of every bearing the row (q, p) with right side s = cross(u_0, u_i), all divided by
/// |L_i - L_0|.
struct NormalEquations
{
  double sxx = 0, sxy = 0, syy = 0;
  double bx = 0, by = 0;
};

[[gnu::always_inline]] inline NormalEquations sumUp(const UnitBearing& first, const UnitBearing* others,
                                                    std::size_t count, const Projections& out)
{
  const double x0 = first.landmark.x(), y0 = first.landmark.y(), c0 = first.unit.x(), s0 = first.unit.y();
  double *const ps = out.p, *const qs = out.q, *const cs = out.c;
  NormalEquations sum;
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < count; ++i)
  {
    const double vx = others[i].landmark.x() - x0, vy = others[i].landmark.y() - y0;
    const double ux = others[i].unit.x(), uy = others[i].unit.y();
    const double p = ux * vx + uy * vy, q = ux * vy - uy * vx, s = uy * c0 - ux * s0;
    const double scale = 1 / (vx * vx + vy * vy);
    const double sp = p * scale, sq = q * scale;
    ps[i] = p;
    qs[i] = q;
    cs[i] = ux * c0 + uy * s0;
    sum.sxx += q * sq;
    sum.sxy += q * sp;
    sum.syy += p * sp;
    sum.bx += s * sq;
    sum.by += s * sp;
  }
  return sum;
}

/// r_i > 0 for every landmark: none lies behind its bearing. r_i / r_0 = Re(conj(u_i) ((L_i - L_0) k + u_0)), here with
/// n = d k, d > 0.
[[gnu::always_inline]] inline bool allAhead(const Projections& at, std::size_t count, double nx, double ny, double d)
{
  const double *const ps = at.p, *const qs = at.q, *const cs = at.c;
  std::int64_t behind = 0;  // as wide as what is compared, so that the loop stays in vectors
  for (std::size_t i = 0; i < count; ++i) behind |= ps[i] * nx - qs[i] * ny + cs[i] * d > 0 ? 0 : 1;
  return behind == 0;
}
}  // namespace

MRPT_EXT_SHORT_LOOP_CLONES
BearingPoseFromUnits solveBearingPoseFromUnits(std::span<const UnitBearing> bearings)
{
  BearingPoseFromUnits result;
  if (bearings.size() < 3) return result;
  result.status = SolveStatus::degenerate;

  const UnitBearing& first = bearings[0];
  const std::size_t count = bearings.size() - 1;
  const Projections projections(count);
  const NormalEquations sum = sumUp(first, bearings.data() + 1, count, projections);
  const double d = sum.sxx * sum.syy - sum.sxy * sum.sxy;
  const double nx = sum.syy * sum.bx - sum.sxy * sum.by, ny = sum.sxx * sum.by - sum.sxy * sum.bx;  // k = n / d
  const double n2 = nx * nx + ny * ny;
  const double largest = static_cast<double>(count) * static_cast<double>(count);
  if (!std::isfinite(d)) return result;
  result.det_ratio = std::max(0.0, d / largest);
  if (d < kSingularBearingRatio * largest || !(n2 > 0) || !std::isfinite(n2)) return result;
  result.status = SolveStatus::behind;
  result.k = {nx / d, ny / d};
  if (!allAhead(projections, count, nx, ny, d)) return result;

  const double inverse = 1 / std::sqrt(n2), distance = d * inverse;
  const double hx = nx * inverse, hy = -ny * inverse;
  result.status = SolveStatus::ok;
  result.heading = {hx, hy};
  result.position = {first.landmark.x() - distance * (hx * first.unit.x() - hy * first.unit.y()),
                     first.landmark.y() - distance * (hx * first.unit.y() + hy * first.unit.x())};
  return result;
}
}  // namespace mrpt_ext
