#include "mrpt_ext/filter/particles/particle_blocks.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace mrpt_ext
{
void forEachBlock(std::size_t particles, unsigned threads, const std::function<void(std::size_t, std::size_t)>& work)
{
  const auto block = [&](std::size_t b)
  { work(b * kParticleBlock, std::min(kParticleBlock, particles - b * kParticleBlock)); };
  const std::size_t blocks = blockCount(particles);
  if (threads > 1 && blocks > 1)
    tbb::parallel_for(std::size_t{0}, blocks, block, tbb::static_partitioner());
  else
    for (std::size_t b = 0; b < blocks; ++b) block(b);
}
}  // namespace mrpt_ext
