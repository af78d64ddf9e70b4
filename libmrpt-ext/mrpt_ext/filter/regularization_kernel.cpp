#include "mrpt_ext/filter/regularization_kernel.h"

#include <algorithm>

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/geometry/vector_math.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kChunk = 512;
constexpr float kGate2 = 16;  // squared Mahalanobis distance of a mode's particles
using Chunk = float[kChunk];

/// The particles of a chunk, the noise they get, and the mode each is nearest to so far.
struct Work
{
  alignas(64) Chunk x, y, phi, a, b, c, distance2;
  alignas(64) std::int32_t nearest[kChunk];
};

[[gnu::always_inline]] inline float wrapped(float angle)
{
  const float turns = vector_math::nearestWhole(angle * 0.159154943F);
  return (angle - turns * 6.28125F) - turns * 1.93530718e-3F;
}

MRPT_EXT_VECTOR_CLONES
void compare(Work& work, const RegularizedMode& mode, std::int32_t number)
{
  const RegularizedMode m = mode;
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < kChunk; ++i)
  {
    const float x = work.x[i] - m.x, y = work.y[i] - m.y, p = wrapped(work.phi[i] - m.phi);
    const float u = m.wxx * x, v = m.wyx * x + m.wyy * y, w = m.wpx * x + m.wpy * y + m.wpp * p;
    const float distance2 = u * u + v * v + w * w;
    const bool nearer = distance2 < work.distance2[i];
    work.nearest[i] = nearer ? number : work.nearest[i];
    work.distance2[i] = nearer ? distance2 : work.distance2[i];
  }
}

MRPT_EXT_VECTOR_CLONES
void move(Work& work, const RegularizedMode& mode, std::int32_t number)
{
  const RegularizedMode m = mode;
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < kChunk; ++i)
  {
    const float x = work.x[i], y = work.y[i], phi = work.phi[i], a = work.a[i], b = work.b[i], c = work.c[i];
    const bool belongs = work.nearest[i] == number;
    const float dp = m.keep * wrapped(phi - m.phi) + m.lpx * a + m.lpy * b + m.lpp * c;
    work.x[i] = belongs ? m.x + m.keep * (x - m.x) + m.lxx * a : x;
    work.y[i] = belongs ? m.y + m.keep * (y - m.y) + m.lyx * a + m.lyy * b : y;
    work.phi[i] = belongs ? wrapped(m.phi + dp) : phi;
  }
}
}  // namespace

RegularizedMode regularizedMode(const GaussianPose& pose, const Vector2d& origin, const Matrix3d& factor,
                                double bandwidth)
{
  const Matrix3d W = factor.triangularView<Eigen::Lower>().solve(Matrix3d::Identity());
  const Matrix3d L = bandwidth * factor;
  const auto f = [](double v) { return static_cast<float>(v); };
  return {.x = f(pose.mean.x - origin.x()),
          .y = f(pose.mean.y - origin.y()),
          .phi = f(pose.mean.phi),
          .wxx = f(W(0, 0)),
          .wyx = f(W(1, 0)),
          .wyy = f(W(1, 1)),
          .wpx = f(W(2, 0)),
          .wpy = f(W(2, 1)),
          .wpp = f(W(2, 2)),
          .keep = f(std::sqrt(1 - square(bandwidth))),
          .lxx = f(L(0, 0)),
          .lyx = f(L(1, 0)),
          .lyy = f(L(1, 1)),
          .lpx = f(L(2, 0)),
          .lpy = f(L(2, 1)),
          .lpp = f(L(2, 2))};
}

void regularizeBlock(ParticleSet& particles, std::span<const RegularizedMode> modes, std::size_t first,
                     std::size_t count, SimdRandom& random)
{
  Work work{};
  for (const std::size_t end = first + count; first < end; first += kChunk)
  {
    const std::size_t n = std::min(kChunk, end - first);
    for (Chunk* noise : {&work.a, &work.b, &work.c}) random.fillGaussians(*noise);
    std::copy_n(&particles.x[first], n, work.x);
    std::copy_n(&particles.y[first], n, work.y);
    std::copy_n(&particles.phi[first], n, work.phi);
    std::fill_n(work.distance2, kChunk, kGate2);
    std::fill_n(work.nearest, kChunk, -1);
    for (std::size_t k = 0; k < modes.size(); ++k) compare(work, modes[k], static_cast<std::int32_t>(k));
    for (std::size_t k = 0; k < modes.size(); ++k) move(work, modes[k], static_cast<std::int32_t>(k));
    std::copy_n(work.x, n, &particles.x[first]);
    std::copy_n(work.y, n, &particles.y[first]);
    std::copy_n(work.phi, n, &particles.phi[first]);
  }
}
}  // namespace mrpt_ext
