#pragma once

#include <csignal>

#include <array>
#include <atomic>

namespace mrpt_ext
{
/// How a program answers signals while this is alive: Ctrl-C (SIGINT), SIGTERM and SIGHUP end it at once with one line,
/// exit code 1 and without temporary files. A signal that the program was started to ignore (nohup) stays ignored.
/// A closed pipe (SIGPIPE) and a limit on the size of files (SIGXFSZ) become errors of writing.
class InterruptGuard
{
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  static constexpr std::size_t kSignals = 6;
  std::array<struct sigaction, kSignals> before_{};
};

/// Within an InterruptGuard: the first signal only sets a flag, so that what is finished can be written. The program
/// ends kGrace after it, or with a second signal, also where nobody looks at the flag.
class DeferredInterrupt
{
 public:
  static constexpr long kGrace = 800'000;  ///< [us] the contract gives a second, of which a busy machine takes some

  DeferredInterrupt();
  ~DeferredInterrupt();
  DeferredInterrupt(const DeferredInterrupt&) = delete;
  DeferredInterrupt& operator=(const DeferredInterrupt&) = delete;

  /// The same one for all; of use to what is built before and runs within.
  [[nodiscard]] static const std::atomic<bool>& flag();
};
}  // namespace mrpt_ext
