#pragma once

#include <cstddef>

namespace mrpt_ext
{
/// Memory that operator new has handed out and not got back, counted for the whole program.
[[nodiscard]] std::size_t allocatedBytes();
/// Most that was handed out at one time since startPeak().
[[nodiscard]] std::size_t peakBytes();
void startPeak();
}  // namespace mrpt_ext
