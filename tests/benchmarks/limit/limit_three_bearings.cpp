#include "limit/limit_three_bearings.h"

namespace mrpt_ext::limit
{
namespace
{
template <class Real>
[[gnu::always_inline]] inline void solveAll(const Real* const (&in)[12], std::size_t count, Real* x, Real* y)
{
  const Real *x1 = in[0], *y1 = in[1], *x2 = in[2], *y2 = in[3], *x3 = in[4], *y3 = in[5];
  const Real *c1 = in[6], *s1 = in[7], *c2 = in[8], *s2 = in[9], *c3 = in[10], *s3 = in[11];
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
  for (std::size_t m = 0; m < count; ++m)
    totalPosition<Real>({x1[m], y1[m], x2[m], y2[m], x3[m], y3[m]}, {c1[m], s1[m], c2[m], s2[m], c3[m], s3[m]}, x[m],
                        y[m]);
}
}  // namespace

void totalPositions(const float* const (&in)[12], std::size_t count, float* x, float* y) { solveAll(in, count, x, y); }
void totalPositions(const double* const (&in)[12], std::size_t count, double* x, double* y)
{
  solveAll(in, count, x, y);
}
}  // namespace mrpt_ext::limit
