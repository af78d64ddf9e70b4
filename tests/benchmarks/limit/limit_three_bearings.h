#pragma once

#include <cstddef>

namespace mrpt_ext::limit
{
/// Position from three bearings and nothing else: ToTal (Pierlot, Van Droogenbroeck 2014) on unit vectors with the
/// cotangents multiplied out. No heading, no look at which way the bearings point, no answer for singular cases.
/// `at` = {x1, y1, x2, y2, x3, y3}, `u` = {c1, s1, c2, s2, c3, s3}. Always inlined, so that every translation unit
/// keeps its own instruction set.
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

/// The same for `count` problems; element k of `in` is the array of the k-th number of {at, u}. Compiled for the
/// processor that builds it.
void totalPositions(const float* const (&in)[12], std::size_t count, float* x, float* y);
void totalPositions(const double* const (&in)[12], std::size_t count, double* x, double* y);
}  // namespace mrpt_ext::limit
