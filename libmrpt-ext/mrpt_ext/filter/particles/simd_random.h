#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "mrpt_ext/geometry/random.h"

namespace mrpt_ext
{
/// Sixteen generators side by side (xoshiro128++, Blackman and Vigna 2019), so that random numbers come as vector code:
/// about a nanosecond for a Gaussian. One object per block of particles, from (seed, block).
class SimdRandom
{
 public:
  static constexpr std::size_t kLanes = 16;

  SimdRandom(std::uint64_t seed, std::uint64_t block);

  /// Standard normal deviates (Box and Muller), at most 5.9 from 0. The size is a multiple of 2 kLanes.
  void fillGaussians(std::span<float> values);

 private:
  void fillBits(std::span<std::uint32_t> values);

  alignas(64) std::uint32_t state_[4][kLanes];
};
}  // namespace mrpt_ext
