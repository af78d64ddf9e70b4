#include "mrpt_ext/app/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace mrpt_ext
{
std::string progressText(const std::string& task, double fraction, double elapsed)
{
  const double share = std::clamp(fraction, 0.0, 1.0);
  std::string text = task + ' ' + std::to_string(static_cast<int>(100 * share)) + " %";
  if (elapsed < 1 || share <= 0) return text;
  const auto left = static_cast<long>(std::ceil(elapsed * (1 - share) / share));
  if (left < 120) return text + ", " + std::to_string(left) + " s left";
  return text + ", " + std::to_string((left + 30) / 60) + " min left";
}

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
  const double elapsed = std::chrono::duration<double>(now - started_).count();
  std::cerr << "\r\x1b[K" << progressText(task_, fraction, elapsed) << std::flush;
}

void ProgressLine::clear()
{
  if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
  drawn_ = false;
}
}  // namespace mrpt_ext
