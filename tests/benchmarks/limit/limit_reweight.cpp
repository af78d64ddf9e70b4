#include "limit/limit_reweight.h"

#include <immintrin.h>

namespace mrpt_ext::limit
{
namespace
{
constexpr std::size_t kLanes = 16;

/// 1 / sqrt(v), the processor's estimate and one Newton step.
inline __m512 inverseRoot(__m512 v)
{
  const __m512 estimate = _mm512_rsqrt14_ps(v);
  const __m512 half = _mm512_mul_ps(_mm512_mul_ps(_mm512_set1_ps(0.5F), v), estimate);
  return _mm512_fmadd_ps(estimate, _mm512_fnmadd_ps(half, estimate, _mm512_set1_ps(0.5F)), estimate);
}

struct Lanes
{
  __m512 x, y, c, s;
};

inline Lanes robotsAt(const Robots& robots, std::size_t i)
{
  return {_mm512_load_ps(robots.x + i), _mm512_load_ps(robots.y + i), _mm512_load_ps(robots.cosine + i),
          _mm512_load_ps(robots.sine + i)};
}

/// log_weight += kappa * (sum_of_cosines - count)
inline void addLogWeight(const Robots& robots, std::size_t i, __m512 sum_of_cosines, int count, float kappa)
{
  const __m512 difference = _mm512_sub_ps(sum_of_cosines, _mm512_set1_ps(static_cast<float>(count)));
  float* at = robots.log_weight + i;
  _mm512_store_ps(at, _mm512_fmadd_ps(_mm512_set1_ps(kappa), difference, _mm512_load_ps(at)));
}
}  // namespace

bool canReweight() { return __builtin_cpu_supports("avx512f") != 0; }

void reweightKnown(const Robots& robots, const Bearing* bearings, int count, float kappa)
{
  for (std::size_t i = 0; i < robots.count; i += kLanes)
  {
    const Lanes at = robotsAt(robots, i);
    __m512 sum = _mm512_setzero_ps();
    for (int k = 0; k < count; ++k)
    {
      const __m512 u = _mm512_set1_ps(bearings[k].u), v = _mm512_set1_ps(bearings[k].v);
      const __m512 dx = _mm512_sub_ps(_mm512_set1_ps(bearings[k].landmark_x), at.x);
      const __m512 dy = _mm512_sub_ps(_mm512_set1_ps(bearings[k].landmark_y), at.y);
      const __m512 px = _mm512_fmadd_ps(at.c, dx, _mm512_mul_ps(at.s, dy));
      const __m512 py = _mm512_fmsub_ps(at.c, dy, _mm512_mul_ps(at.s, dx));
      const __m512 distance2 = _mm512_fmadd_ps(px, px, _mm512_mul_ps(py, py));
      const __m512 along = _mm512_fmadd_ps(u, px, _mm512_mul_ps(v, py));
      sum = _mm512_fmadd_ps(along, inverseRoot(distance2), sum);
    }
    addLogWeight(robots, i, sum, count, kappa);
  }
}

void reweightNearest(const Robots& robots, const Bearing* ten_bearings, const float* landmark_x,
                     const float* landmark_y, int landmarks, float kappa)
{
  constexpr int kBearings = 10;
  for (std::size_t i = 0; i < robots.count; i += kLanes)
  {
    const Lanes at = robotsAt(robots, i);
    __m512 ray_x[kBearings], ray_y[kBearings], best[kBearings];
    for (int k = 0; k < kBearings; ++k)
    {
      const __m512 u = _mm512_set1_ps(ten_bearings[k].u), v = _mm512_set1_ps(ten_bearings[k].v);
      ray_x[k] = _mm512_fmsub_ps(at.c, u, _mm512_mul_ps(at.s, v));
      ray_y[k] = _mm512_fmadd_ps(at.s, u, _mm512_mul_ps(at.c, v));
      best[k] = _mm512_set1_ps(-2);
    }
    for (int j = 0; j < landmarks; ++j)
    {
      __m512 dx = _mm512_sub_ps(_mm512_set1_ps(landmark_x[j]), at.x);
      __m512 dy = _mm512_sub_ps(_mm512_set1_ps(landmark_y[j]), at.y);
      const __m512 inverse = inverseRoot(_mm512_fmadd_ps(dx, dx, _mm512_mul_ps(dy, dy)));
      dx = _mm512_mul_ps(dx, inverse);
      dy = _mm512_mul_ps(dy, inverse);
      for (int k = 0; k < kBearings; ++k)
        best[k] = _mm512_max_ps(best[k], _mm512_fmadd_ps(ray_x[k], dx, _mm512_mul_ps(ray_y[k], dy)));
    }
    __m512 sum = best[0];
    for (int k = 1; k < kBearings; ++k) sum = _mm512_add_ps(sum, best[k]);
    addLogWeight(robots, i, sum, kBearings, kappa);
  }
}
}  // namespace mrpt_ext::limit
