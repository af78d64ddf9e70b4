#include "mrpt_ext/solvers/three_bearing_pose_batch.h"

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/solvers/three_bearing_pose.h"

namespace mrpt_ext
{
namespace
{
/// With the optimiser told that the arrays are apart; the headings are left out when there is no place for them.
template <bool WithHeadings, class Real>
[[gnu::always_inline]] inline void solveAll(const ThreeBearingArrays<Real>& in, const PositionArrays<Real>& out,
                                            const HeadingArrays<Real>& headings)
{
  const Real *x1 = in.x[0], *x2 = in.x[1], *x3 = in.x[2], *y1 = in.y[0], *y2 = in.y[1], *y3 = in.y[2];
  const Real *c1 = in.c[0], *c2 = in.c[1], *c3 = in.c[2], *s1 = in.s[0], *s2 = in.s[1], *s3 = in.s[2];
  Real *x = out.x, *y = out.y, *c = headings.c, *s = headings.s;
  Real* valid = out.valid;
  const std::size_t count = in.count;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
  for (std::size_t m = 0; m < count; ++m)
  {
    const ThreeCircleMeeting<Real> at = meetThreeCircles<Real>(
        {x1[m], y1[m], c1[m], s1[m]}, {x2[m], y2[m], c2[m], s2[m]}, {x3[m], y3[m], c3[m], s3[m]});
    const Real vx = x1[m] - x2[m] - at.qx, vy = y1[m] - y2[m] - at.qy;
    const Real length2 = vx * vx + vy * vy;
    const bool ok = at.firm & (at.ahead12 > 0) & (at.ahead23 > 0) & (length2 > 0) &
                    (length2 < std::numeric_limits<Real>::infinity());
    x[m] = ok ? x2[m] + at.qx : 0;
    y[m] = ok ? y2[m] + at.qy : 0;
    valid[m] = ok ? 1 : 0;
    if constexpr (WithHeadings)
    {
      const Real inverse = 1 / std::sqrt(length2);
      c[m] = ok ? (vx * c1[m] + vy * s1[m]) * inverse : 1;
      s[m] = ok ? (vy * c1[m] - vx * s1[m]) * inverse : 0;
    }
  }
}
}  // namespace

MRPT_EXT_VECTOR_CLONES
void positionsFromThreeBearings(const ThreeBearingArrays<float>& problems, const PositionArrays<float>& positions)
{
  solveAll<false, float>(problems, positions, {});
}

MRPT_EXT_VECTOR_CLONES
void positionsFromThreeBearings(const ThreeBearingArrays<double>& problems, const PositionArrays<double>& positions)
{
  solveAll<false, double>(problems, positions, {});
}

MRPT_EXT_VECTOR_CLONES
void posesFromThreeBearings(const ThreeBearingArrays<float>& problems, const PositionArrays<float>& positions,
                            const HeadingArrays<float>& headings)
{
  solveAll<true, float>(problems, positions, headings);
}

MRPT_EXT_VECTOR_CLONES
void posesFromThreeBearings(const ThreeBearingArrays<double>& problems, const PositionArrays<double>& positions,
                            const HeadingArrays<double>& headings)
{
  solveAll<true, double>(problems, positions, headings);
}
}  // namespace mrpt_ext
