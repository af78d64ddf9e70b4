#include "mrpt_ext/rawlog/allocation_limit.h"

#include <cstdlib>
#include <limits>
#include <new>

namespace mrpt_ext
{
namespace
{
thread_local std::size_t largest_allocation = std::numeric_limits<std::size_t>::max();
}

AllocationLimit::AllocationLimit(std::size_t bytes) : before_(largest_allocation) { largest_allocation = bytes; }

AllocationLimit::~AllocationLimit() { largest_allocation = before_; }
}  // namespace mrpt_ext

// The forms for arrays call these. Weak: a program that replaces them itself keeps its own.
__attribute__((weak)) void* operator new(std::size_t size)
{
  if (size > mrpt_ext::largest_allocation) throw std::bad_alloc();
  while (true)
  {
    if (void* const memory = std::malloc(size > 0 ? size : 1)) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (!handler) throw std::bad_alloc();
    handler();
  }
}

// The standard library's calls the one above; that of the address sanitizer does not, and would not match our delete.
__attribute__((weak)) void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  try
  {
    return ::operator new(size);
  }
  catch (const std::bad_alloc&)
  {
    return nullptr;
  }
}

__attribute__((weak)) void operator delete(void* memory) noexcept { std::free(memory); }
__attribute__((weak)) void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
__attribute__((weak)) void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
