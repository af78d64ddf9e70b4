#include "mrpt_ext/filter/motion/motion_kernel.h"

#include <algorithm>

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/geometry/vector_math.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kChunk = 512;  // particles moved at a time: their noise stays in the first-level cache
using Chunk = float[kChunk];

/// Poses of one chunk.
struct Poses
{
  float *x, *y, *phi;
  std::size_t count;
};

/// The increment of each particle, before noise.
struct Increments
{
  alignas(64) Chunk x, y, turn;
};

struct Noise
{
  alignas(64) Chunk a, b, c;
};

[[gnu::always_inline]] inline void moveOne(const Poses& poses, std::size_t i, const MotionStep& step, float x, float y,
                                           float turn, const Noise& noise)
{
  constexpr float kInvTwoPi = 0.159154943F, kTwoPiHigh = 6.28125F, kTwoPiLow = 1.93530718e-3F;
  const float t = step.std_turn * noise.c[i];
  const float dx = x + step.xa * noise.a[i] + step.swing_x * t;
  const float dy = y + step.ya * noise.a[i] + step.yb * noise.b[i] + step.swing_y * t;
  const float phi = poses.phi[i];
  const auto [s, c] = vector_math::sineCosineOf(phi);
  poses.x[i] += c * dx - s * dy;
  poses.y[i] += s * dx + c * dy;
  const float turned = phi + (turn + t), turns = vector_math::nearestWhole(turned * kInvTwoPi);
  poses.phi[i] = (turned - turns * kTwoPiHigh) - turns * kTwoPiLow;
}

MRPT_EXT_VECTOR_CLONES
void moveTogether(const Poses& at, const MotionStep& motion, const Noise& noise)
{
  const Poses poses = at;
  const MotionStep step = motion;
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < poses.count; ++i) moveOne(poses, i, step, step.x, step.y, step.turn, noise);
}

MRPT_EXT_VECTOR_CLONES
void moveEach(const Poses& at, const MotionStep& motion, const Increments& increments, const Noise& noise)
{
  const Poses poses = at;
  const MotionStep step = motion;
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < poses.count; ++i)
    moveOne(poses, i, step, increments.x[i], increments.y[i], increments.turn[i], noise);
}

/// What the errors of the particles change of the motion.
struct Changes
{
  alignas(64) Chunk distance;    // factor
  alignas(64) Chunk turn, x, y;  // sums over the errors, see BiasLever
};

MRPT_EXT_VECTOR_CLONES
void changeIncrements(const MotionStep& motion, const Changes& changes, Increments& increments)
{
  const MotionStep step = motion;
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < kChunk; ++i)
  {
    const auto [s, c] = vector_math::sineCosineOf(0.5F * changes.turn[i]);
    increments.x[i] = changes.distance[i] * (c * step.x - s * step.y + changes.x[i]);
    increments.y[i] = changes.distance[i] * (s * step.x + c * step.y + changes.y[i]);
    increments.turn[i] = step.turn + changes.turn[i];
  }
}

bool hasErrors(const ParticleSet& particles)
{
  return std::any_of(particles.bias_states.begin(), particles.bias_states.end(),
                     [](const BiasState& state) { return belongsToOdometry(state.kind); });
}

void addError(BiasKind kind, const BiasLever& lever, const float* error, std::size_t count, Changes& changes)
{
  if (kind == BiasKind::distance_scale)
  {
    for (std::size_t i = 0; i < count; ++i) changes.distance[i] += error[i];
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    changes.turn[i] += lever.turn * error[i];
    changes.x[i] += lever.x * error[i];
    changes.y[i] += lever.y * error[i];
  }
}

void moveWithErrors(const ParticleSet& particles, const Poses& poses, const MotionStep& step,
                    const std::vector<BiasLever>& levers, std::size_t first, const Noise& noise)
{
  Changes changes;
  std::fill_n(changes.distance, kChunk, 1.0F);
  for (Chunk* sum : {&changes.turn, &changes.x, &changes.y}) std::fill_n(*sum, kChunk, 0.0F);
  for (std::size_t k = 0; k < particles.bias_states.size(); ++k)
    if (belongsToOdometry(particles.bias_states[k].kind))
      addError(particles.bias_states[k].kind, levers[k], &particles.bias[k][first], poses.count, changes);
  Increments increments;
  changeIncrements(step, changes, increments);
  moveEach(poses, step, increments, noise);
}
}  // namespace

void moveBlock(ParticleSet& particles, const MotionStep& step, const std::vector<BiasLever>& levers, std::size_t first,
               std::size_t count, SimdRandom& random)
{
  const bool errs = hasErrors(particles);
  Noise noise;
  for (const std::size_t end = first + count; first < end; first += kChunk)
  {
    for (Chunk* column : {&noise.a, &noise.b, &noise.c}) random.fillGaussians(*column);
    const Poses poses{&particles.x[first], &particles.y[first], &particles.phi[first], std::min(kChunk, end - first)};
    if (errs)
      moveWithErrors(particles, poses, step, levers, first, noise);
    else
      moveTogether(poses, step, noise);
  }
}
}  // namespace mrpt_ext
