#include "limit/limit_three_bearings.h"

namespace mrpt_ext::limit
{
namespace
{
template <class Real>
[[gnu::always_inline]] inline void totalPosition(const Real (&at)[6], const Real (&u)[6], Real& x, Real& y)
{
  const Real px = at[0] - at[2], py = at[1] - at[3], qx = at[4] - at[2], qy = at[5] - at[3];
  const Real cos_p = u[0] * u[2] + u[1] * u[3], sin_p = u[3] * u[0] - u[2] * u[1];
  const Real cos_q = u[2] * u[4] + u[3] * u[5], sin_q = u[5] * u[2] - u[4] * u[3];
  const Real over = sin_p * sin_q - cos_p * cos_q, under = cos_p * sin_q + cos_q * sin_p;
  const Real ax = sin_p * px + cos_p * py, ay = sin_p * py - cos_p * px;
  const Real bx = sin_q * qx - cos_q * qy, by = sin_q * qy + cos_q * qx;
  const Real cx = under * (qx + px) + over * (qy - py), cy = under * (qy + py) - over * (qx - px);
  const Real k = under * (px * qx + py * qy) + over * (px * qy - qx * py);
  const Real dx = sin_q * ax - sin_p * bx, dy = sin_q * ay - sin_p * by;
  const Real ex = under * bx - sin_q * cx, ey = under * by - sin_q * cy;
  const Real factor = k * sin_q / (dx * ey - dy * ex);
  x = at[2] + factor * dy;
  y = at[3] - factor * dx;
}

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

double sumOfTotalPositions(const double* at, const double* u, std::size_t count)
{
  double sum = 0;
  for (std::size_t m = 0; m < count; ++m)
  {
    const double *l = at + 6 * m, *c = u + 6 * m;
    double x, y;
    totalPosition<double>({l[0], l[1], l[2], l[3], l[4], l[5]}, {c[0], c[1], c[2], c[3], c[4], c[5]}, x, y);
    sum += x + y;
  }
  return sum;
}

void totalPositions(const float* const (&in)[12], std::size_t count, float* x, float* y) { solveAll(in, count, x, y); }
void totalPositions(const double* const (&in)[12], std::size_t count, double* x, double* y)
{
  solveAll(in, count, x, y);
}
}  // namespace mrpt_ext::limit
