#include "mrpt_ext/app/interrupt.h"

#include <csignal>

namespace mrpt_ext
{
namespace
{
std::atomic<bool> interrupt_requested{false};

extern "C" void onSignal(int signal)
{
  interrupt_requested = true;
  std::signal(signal, SIG_DFL);
}
}  // namespace

InterruptGuard::InterruptGuard()
{
  interrupt_requested = false;
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

InterruptGuard::~InterruptGuard()
{
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& InterruptGuard::flag() const { return interrupt_requested; }
}  // namespace mrpt_ext
