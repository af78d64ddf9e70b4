#pragma once

#include <cstddef>

namespace mrpt_ext
{
/// While this is alive, the thread cannot allocate more than `bytes` in one piece: std::bad_alloc. MRPT's classes take
/// a length from a log and allocate for it before they read on; a damaged length must not cost gigabytes.
///
/// Acts on the global operator new, which this room replaces by one that looks at the limit, otherwise does the same.
/// Where a program has an operator new of its own, or loads this as a shared library (the Python module), that one
/// stays and the limit does nothing.
class AllocationLimit
{
 public:
  explicit AllocationLimit(std::size_t bytes);
  ~AllocationLimit();
  AllocationLimit(const AllocationLimit&) = delete;
  AllocationLimit& operator=(const AllocationLimit&) = delete;

 private:
  std::size_t before_;
};
}  // namespace mrpt_ext
