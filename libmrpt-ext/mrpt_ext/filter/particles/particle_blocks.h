#pragma once

#include <cstddef>
#include <functional>

namespace mrpt_ext
{
/// Particles that one task works on: always the same ones, so that nothing depends on the number of threads.
inline constexpr std::size_t kParticleBlock = 2048;

[[nodiscard]] constexpr std::size_t blockCount(std::size_t particles)
{
  return (particles + kParticleBlock - 1) / kParticleBlock;
}

/// Calls `work(first, count)` for every block of `particles`, with `threads` > 1 several at a time.
void forEachBlock(std::size_t particles, unsigned threads, const std::function<void(std::size_t, std::size_t)>& work);
}  // namespace mrpt_ext
