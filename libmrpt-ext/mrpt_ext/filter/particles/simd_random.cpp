#include "mrpt_ext/filter/particles/simd_random.h"

#include <algorithm>

#include "mrpt_ext/geometry/vector_clones.h"
#include "mrpt_ext/geometry/vector_math.h"

namespace mrpt_ext
{
namespace
{
constexpr std::size_t kLanes = SimdRandom::kLanes;
constexpr std::size_t kChunk = 512;  // numbers made at a time

[[gnu::always_inline]] inline std::uint32_t rotated(std::uint32_t v, int by) { return (v << by) | (v >> (32 - by)); }

/// `rounds` numbers of every lane.
MRPT_EXT_VECTOR_CLONES
void nextBits(std::uint32_t (&state)[4][kLanes], std::size_t rounds, std::uint32_t* values)
{
  for (std::size_t r = 0; r < rounds; ++r) MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t l = 0; l < kLanes; ++l)
  {
    const std::uint32_t s0 = state[0][l], s1 = state[1][l], s2 = state[2][l] ^ s0, s3 = state[3][l] ^ s1;
    values[r * kLanes + l] = rotated(s0 + state[3][l], 7) + s0;
    state[1][l] = s1 ^ s2;
    state[0][l] = s0 ^ s3;
    state[2][l] = s2 ^ (s1 << 9);
    state[3][l] = rotated(s3, 11);
  }
}

/// Two Gaussians from two numbers: the radius from the first half of `bits`, the angle from the second.
MRPT_EXT_VECTOR_CLONES
void gaussianPairs(const std::uint32_t* bits, std::size_t pairs, float* values)
{
  constexpr float kUnit = 0x1p-24F;
  MRPT_EXT_INDEPENDENT_ITERATIONS
  for (std::size_t i = 0; i < pairs; ++i)
  {
    const auto whole = static_cast<float>(static_cast<std::int32_t>(bits[i] >> 8));
    const float radius = std::sqrt(-2.0F * vector_math::logOf((whole + 0.5F) * kUnit));
    const auto turn = static_cast<float>(static_cast<std::int32_t>(bits[pairs + i] >> 8));
    const auto [s, c] = vector_math::sineCosineOf(turn * (kUnit * 6.28318531F));
    values[i] = radius * c;
    values[pairs + i] = radius * s;
  }
}
}  // namespace

SimdRandom::SimdRandom(std::uint64_t seed, std::uint64_t block)
{
  RandomStream random(seed, block);
  for (auto& word : state_)
    for (std::uint32_t& value : word) value = static_cast<std::uint32_t>(random.nextBits() >> 32);
}

void SimdRandom::fillBits(std::span<std::uint32_t> values) { nextBits(state_, values.size() / kLanes, values.data()); }

void SimdRandom::fillGaussians(std::span<float> values)
{
  alignas(64) std::uint32_t bits[kChunk];
  for (std::size_t first = 0; first < values.size(); first += kChunk)
  {
    const std::size_t count = std::min(kChunk, values.size() - first);
    fillBits(std::span(bits).first(count));
    gaussianPairs(bits, count / 2, values.data() + first);
  }
}
}  // namespace mrpt_ext
