#include "mrpt_ext/pipeline/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace mrpt_ext
{
ProgressLine::ProgressLine(bool enabled, std::string task)
    : enabled_(enabled && isatty(STDERR_FILENO) == 1), task_(std::move(task))
{
}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(double fraction)
{
  if (!enabled_) return;
  const auto now = std::chrono::steady_clock::now();
  if (drawn_ && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  drawn_ = true;
  const int percent = static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0));
  std::cerr << "\r\x1b[K" << task_ << ' ' << percent << " %" << std::flush;
}

void ProgressLine::clear()
{
  if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
  drawn_ = false;
}
}  // namespace mrpt_ext
