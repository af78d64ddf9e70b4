#include "mrpt_ext/correspondence/bearings/triple_pose.h"

#include <cmath>

#include "mrpt_ext/geometry/vector_clones.h"

namespace mrpt_ext
{
namespace
{
constexpr float kLargest = 1e3F;  // [m, rad] of a pose that its three landmarks leave undetermined
}

void TriplePoses::resize(std::size_t size)
{
  count = size;
  if (x.size() >= size) return;
  for (auto* v : {&x, &y, &c, &s, &ix, &iy, &ih, &jx, &jy, &jh, &kx, &ky, &kh}) v->resize(size);
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
  float* __restrict ix = poses.ix.data(), * __restrict iy = poses.iy.data(), * __restrict ih = poses.ih.data();
  float* __restrict jx = poses.jx.data(), * __restrict jy = poses.jy.data(), * __restrict jh = poses.jh.data();
  float* __restrict kx = poses.kx.data(), * __restrict ky = poses.ky.data(), * __restrict kh = poses.kh.data();
  const TripleBearings b = bearings;
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t n = 0; n < hits.count; ++n)
  {
    const float px = hx[n], py = hy[n];
    const float djx = first_x[hj[n]] - px, djy = first_y[hj[n]] - py;
    const float dkx = second_x[hk[n]] - px, dky = second_y[hk[n]] - py;
    const float i2 = 1 / (px * px + py * py), j2 = 1 / (djx * djx + djy * djy), k2 = 1 / (dkx * dkx + dky * dky);
    const float inverse = std::sqrt(i2);
    x[n] = px;
    y[n] = py;
    c[n] = -(px * b.middle_x + py * b.middle_y) * inverse;
    s[n] = (px * b.middle_y - py * b.middle_x) * inverse;

    const float eix = -py * i2, eiy = px * i2;  // the landmark i lies at (-px, -py)
    const float fx = djy * j2 - eix, fy = -djx * j2 - eiy;
    const float gx = dky * k2 - eix, gy = -dkx * k2 - eiy;
    const float determinant = fx * gy - fy * gx;
    const float inverse_det = determinant / (determinant * determinant + 1e-30F);
    // d position / d bearing, then d heading / d bearing
    const float ajx = gy * inverse_det, ajy = -gx * inverse_det;
    const float akx = -fy * inverse_det, aky = fx * inverse_det;
    const float aix = -ajx - akx, aiy = -ajy - aky;
    const auto store = [](float value, float std, float& out)
    {
      const float v = value * std;
      out = v > kLargest ? kLargest : (v < -kLargest ? -kLargest : v);
    };
    store(aix, b.std_middle, ix[n]);
    store(aiy, b.std_middle, iy[n]);
    store(eix * aix + eiy * aiy - 1, b.std_middle, ih[n]);
    store(ajx, b.std_first, jx[n]);
    store(ajy, b.std_first, jy[n]);
    store(eix * ajx + eiy * ajy, b.std_first, jh[n]);
    store(akx, b.std_second, kx[n]);
    store(aky, b.std_second, ky[n]);
    store(eix * akx + eiy * aky, b.std_second, kh[n]);
  }
}
}  // namespace mrpt_ext
