#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>

namespace mrpt_ext
{
/// printf into a string of the length it takes.
template <typename First, typename... Values>
[[nodiscard]] std::string formatted(const char* format, First first, Values... values)
{
  const int length = std::snprintf(nullptr, 0, format, first, values...);
  std::string text(static_cast<std::size_t>(std::max(length, 0)), '\0');
  std::snprintf(text.data(), text.size() + 1, format, first, values...);
  return text;
}

/// "1 frame", "2 frames"; `what`: a noun that takes an s.
[[nodiscard]] inline std::string countOf(std::size_t count, const std::string& what)
{
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}
}  // namespace mrpt_ext
