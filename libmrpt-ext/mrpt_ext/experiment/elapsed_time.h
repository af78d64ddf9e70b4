#pragma once

#include <chrono>

namespace mrpt_ext
{
/// Wall time [ms] since `start`.
[[nodiscard]] inline double millisecondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}
}  // namespace mrpt_ext
