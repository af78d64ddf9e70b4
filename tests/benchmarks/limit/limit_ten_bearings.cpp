#include "limit/limit_ten_bearings.h"

namespace mrpt_ext::limit
{
namespace
{
inline double sumOfPosition(const double* at, const double* u, std::size_t bearings)
{
  double p00 = 0, p01 = 0, p11 = 0, q0 = 0, q1 = 0;
  for (std::size_t i = 1; i < bearings; ++i)
  {
    const double vx = at[2 * i] - at[0], vy = at[2 * i + 1] - at[1];
    const double w = 1 / (vx * vx + vy * vy), bx = vx * w, by = -vy * w;
    const double c = u[2 * i] * u[0] + u[2 * i + 1] * u[1], s = u[2 * i + 1] * u[0] - u[2 * i] * u[1];
    const double ax = c * vx + s * vy, ay = s * vx - c * vy;
    const double m00 = ax * ax * w - 1, m01 = ax * ay * w, m11 = ay * ay * w - 1;
    p00 += m00;
    p01 += m01;
    p11 += m11;
    q0 += m00 * bx + m01 * by;
    q1 += m01 * bx + m11 * by;
  }
  const double fx = p01 * q1 - p11 * q0, fy = p01 * q0 - p00 * q1;
  const double g = (p00 * p11 - p01 * p01) / (fx * fx + fy * fy);
  return at[0] - fx * g + at[1] + fy * g;
}
}  // namespace

double sumOfLinearPositions(const double* landmarks, const double* units, std::size_t bearings, std::size_t count)
{
  double sum = 0;
  for (std::size_t m = 0; m < count; ++m)
    sum += sumOfPosition(landmarks + 2 * bearings * m, units + 2 * bearings * m, bearings);
  return sum;
}
}  // namespace mrpt_ext::limit
