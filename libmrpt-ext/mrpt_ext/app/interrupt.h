#pragma once

#include <atomic>

namespace mrpt_ext
{
/// While alive, Ctrl-C (SIGINT) and SIGTERM set a flag instead of ending the program, so that what is finished can be
/// written. A second signal ends it at once.
class InterruptGuard
{
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  [[nodiscard]] const std::atomic<bool>& flag() const;
};
}  // namespace mrpt_ext
