#include "mrpt_ext/correspondence/triple_pose.h"

#include <cmath>

#include "mrpt_ext/geometry/vector_clones.h"

namespace mrpt_ext
{
namespace
{
constexpr float kLargestVariance = 1e6F;  // of a pose that its three landmarks leave undetermined
}

void TriplePoses::resize(std::size_t size)
{
  count = size;
  if (x.size() >= size) return;
  for (auto* v : {&x, &y, &c, &s, &xx, &xy, &xh, &yy, &yh, &hh}) v->resize(size);
}

MRPT_EXT_VECTOR_CLONES
void posesOfHits(const TripleBearings& bearings, const Neighbours& first, const Neighbours& second,
                 const TripleHits& hits, TriplePoses& poses)
{
  poses.resize(hits.count);
  const float *hx = hits.x.data(), *hy = hits.y.data();
  const std::uint32_t *hj = hits.j.data(), *hk = hits.k.data();
  const float *first_x = first.x.data(), *first_y = first.y.data();
  const float *second_x = second.x.data(), *second_y = second.y.data();
  float* __restrict x = poses.x.data(), * __restrict y = poses.y.data();
  float* __restrict c = poses.c.data(), * __restrict s = poses.s.data();
  float* __restrict xx = poses.xx.data(), * __restrict xy = poses.xy.data(), * __restrict xh = poses.xh.data();
  float* __restrict yy = poses.yy.data(), * __restrict yh = poses.yh.data(), * __restrict hh = poses.hh.data();
  const TripleBearings b = bearings;
#pragma GCC ivdep
  for (std::size_t n = 0; n < hits.count; ++n)
  {
    const float px = hx[n], py = hy[n];
    const float jx = first_x[hj[n]] - px, jy = first_y[hj[n]] - py;
    const float kx = second_x[hk[n]] - px, ky = second_y[hk[n]] - py;
    const float i2 = 1 / (px * px + py * py), j2 = 1 / (jx * jx + jy * jy), k2 = 1 / (kx * kx + ky * ky);
    const float inverse = std::sqrt(i2);
    x[n] = px;
    y[n] = py;
    c[n] = -(px * b.middle_x + py * b.middle_y) * inverse;
    s[n] = (px * b.middle_y - py * b.middle_x) * inverse;

    const float eix = -py * i2, eiy = px * i2;  // the landmark i lies at (-px, -py)
    const float fx = jy * j2 - eix, fy = -jx * j2 - eiy;
    const float gx = ky * k2 - eix, gy = -kx * k2 - eiy;
    const float determinant = fx * gy - fy * gx;
    const float inverse_det = determinant / (determinant * determinant + 1e-30F);
    // d position / d reading, then d heading / d reading
    const float ajx = gy * inverse_det, ajy = -gx * inverse_det;
    const float akx = -fy * inverse_det, aky = fx * inverse_det;
    const float aix = -ajx - akx, aiy = -ajy - aky;
    const float ajh = eix * ajx + eiy * ajy, akh = eix * akx + eiy * aky, aih = eix * aix + eiy * aiy - 1;
    const auto sum = [&](float i, float j, float k)
    {
      const float v = b.var_middle * i + b.var_first * j + b.var_second * k;
      return v < kLargestVariance ? v : kLargestVariance;
    };
    xx[n] = sum(aix * aix, ajx * ajx, akx * akx);
    xy[n] = sum(aix * aiy, ajx * ajy, akx * aky);
    xh[n] = sum(aix * aih, ajx * ajh, akx * akh);
    yy[n] = sum(aiy * aiy, ajy * ajy, aky * aky);
    yh[n] = sum(aiy * aih, ajy * ajh, aky * akh);
    hh[n] = sum(aih * aih, ajh * ajh, akh * akh);
  }
}
}  // namespace mrpt_ext
