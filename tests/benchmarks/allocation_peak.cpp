#include "allocation_peak.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace
{
std::atomic<std::size_t> allocated{0}, peak{0};

void* counted(void* memory)
{
  if (!memory) throw std::bad_alloc();
  const std::size_t now = allocated += malloc_usable_size(memory);
  for (std::size_t seen = peak; now > seen && !peak.compare_exchange_weak(seen, now);)
  {
  }
  return memory;
}

void release(void* memory)
{
  if (!memory) return;
  allocated -= malloc_usable_size(memory);
  std::free(memory);
}

std::size_t wholeBlocks(std::size_t size, std::size_t alignment)
{
  return (size + alignment - 1) / alignment * alignment;
}
}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size > 0 ? size : 1)); }
void* operator new(std::size_t size, std::align_val_t alignment)
{
  const auto step = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(step, wholeBlocks(size > 0 ? size : 1, step)));
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace mrpt_ext
{
std::size_t allocatedBytes() { return allocated; }
std::size_t peakBytes() { return peak; }
void startPeak() { peak = allocated.load(); }
}  // namespace mrpt_ext
