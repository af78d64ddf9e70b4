#include "mrpt_ext/app/interrupt.h"

#include <sys/time.h>
#include <unistd.h>

#include <string_view>

#include "mrpt_ext/app/exit_codes.h"
#include "mrpt_ext/files/staged_file.h"

namespace mrpt_ext
{
namespace
{
constexpr std::array<int, 4> kEnding{SIGINT, SIGTERM, SIGHUP, SIGALRM};
constexpr std::array<int, 2> kIgnored{SIGPIPE, SIGXFSZ};

std::atomic<bool> interrupt_seen{false}, interrupt_deferred{false}, on_terminal{false};

/// In a signal handler: nothing here locks or allocates.
[[noreturn]] void endProgram()
{
  constexpr std::string_view kClearLine = "\r\x1b[K";  // of the progress
  constexpr std::string_view kLine = "interrupted: what was finished is on disk, the rest ends here\n";
  removeStagedFiles();
  if (on_terminal) static_cast<void>(!write(STDERR_FILENO, kClearLine.data(), kClearLine.size()));
  static_cast<void>(!write(STDERR_FILENO, kLine.data(), kLine.size()));
  _exit(kExitFailed);
}

void startTimer(long microseconds)
{
  const itimerval timer{{0, 0}, {0, microseconds}};
  setitimer(ITIMER_REAL, &timer, nullptr);
}

extern "C" void onSignal(int signal)
{
  const bool is_second = interrupt_seen.exchange(true);
  if (signal == SIGALRM || is_second || !interrupt_deferred) endProgram();
  startTimer(DeferredInterrupt::kGrace);
}
}  // namespace

InterruptGuard::InterruptGuard()
{
  static_assert(kEnding.size() + kIgnored.size() == kSignals);
  interrupt_seen = false;
  on_terminal = isatty(STDERR_FILENO) == 1;
  struct sigaction action
  {
  };
  sigfillset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  std::size_t i = 0;
  for (const int signal : kEnding)
  {
    action.sa_handler = onSignal;
    sigaction(signal, nullptr, &before_[i]);
    if (before_[i++].sa_handler != SIG_IGN || signal == SIGALRM) sigaction(signal, &action, nullptr);
  }
  action.sa_handler = SIG_IGN;
  for (const int signal : kIgnored) sigaction(signal, &action, &before_[i++]);
}

InterruptGuard::~InterruptGuard()
{
  startTimer(0);
  std::size_t i = 0;
  for (const int signal : kEnding) sigaction(signal, &before_[i++], nullptr);
  for (const int signal : kIgnored) sigaction(signal, &before_[i++], nullptr);
}

DeferredInterrupt::DeferredInterrupt() { interrupt_deferred = true; }

DeferredInterrupt::~DeferredInterrupt() { interrupt_deferred = false; }

const std::atomic<bool>& DeferredInterrupt::flag() { return interrupt_seen; }
}  // namespace mrpt_ext
