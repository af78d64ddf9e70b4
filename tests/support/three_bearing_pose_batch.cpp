#include "three_bearing_pose_batch.h"

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
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t m = 0; m < count; ++m)
  {
    const ThreeBearingSolution<Real> at = solveThreeBearings<Real>(
        {x1[m], y1[m], c1[m], s1[m]}, {x2[m], y2[m], c2[m], s2[m]}, {x3[m], y3[m], c3[m], s3[m]});
    const bool ok = at.firm & at.ahead();
    const Real inverse = 1 / at.n2, factor = at.d * inverse;
    x[m] = ok ? x1[m] - factor * (at.nx * c1[m] + at.ny * s1[m]) : 0;
    y[m] = ok ? y1[m] - factor * (at.nx * s1[m] - at.ny * c1[m]) : 0;
    valid[m] = ok ? 1 : 0;
    if constexpr (WithHeadings)
    {
      const Real turn = std::copysign(std::sqrt(inverse), at.d);
      c[m] = ok ? turn * at.nx : 1;
      s[m] = ok ? -turn * at.ny : 0;
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
