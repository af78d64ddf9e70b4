#include "mrpt_ext/filter/particles/particle_blocks.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "mrpt_ext/geometry/work_counter.h"

namespace mrpt_ext
{
void forEachBlock(std::size_t particles, unsigned threads, const std::function<void(std::size_t, std::size_t)>& work)
{
  const auto block = [&](std::size_t b)
  { work(b * kParticleBlock, std::min(kParticleBlock, particles - b * kParticleBlock)); };
  const std::size_t blocks = blockCount(particles);
  if (threads <= 1 || blocks <= 1)
  {
    for (std::size_t b = 0; b < blocks; ++b) block(b);
    return;
  }
  const WorkCounter::Undivided other_threads_take_part;
  // TBB hands the blocks over and back in its library, where the thread sanitizer does not look; the counter shows it.
  std::atomic<std::size_t> left;
  left.store(blocks, std::memory_order_release);
  const auto shown = [&](std::size_t b)
  {
    (void)left.load(std::memory_order_acquire);
    block(b);
    left.fetch_sub(1, std::memory_order_release);
  };
  tbb::parallel_for(std::size_t{0}, blocks, shown, tbb::static_partitioner());
  (void)left.load(std::memory_order_acquire);
}
}  // namespace mrpt_ext
