#pragma once

#include <cstdint>
#include <cstring>

namespace mrpt_ext
{
/// A bool that MRPT has copied from a log, where any byte may stand for it: true only for 1. Looking at it as a bool
/// would be undefined.
[[nodiscard]] inline bool isTrue(const bool& logged)
{
  std::uint8_t byte = 0;
  std::memcpy(&byte, &logged, 1);
  return byte == 1;
}
}  // namespace mrpt_ext
