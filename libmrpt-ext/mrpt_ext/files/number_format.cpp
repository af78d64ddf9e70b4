#include "mrpt_ext/files/number_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace mrpt_ext
{
namespace
{
// std::from_chars takes '-' but not '+'.
std::string_view withoutPlus(std::string_view text)
{
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
  return plus ? text.substr(1) : text;
}

template <typename Number>
std::optional<Number> parseWhole(std::string_view text)
{
  text = withoutPlus(text);
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stopped_at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stopped_at != end) return std::nullopt;
  return value;
}
}  // namespace

std::string fixedText(double value, int decimals)
{
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : (value > 0 ? "inf" : "-inf");
  std::array<char, 400> buffer;  // the largest double has 309 digits before the point
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed,
                                 std::clamp(decimals, 0, 60))
                       .ptr;
  const std::string text(buffer.data(), end);
  const bool is_minus_zero = text[0] == '-' && text.find_first_not_of("-0.") == std::string::npos;
  return is_minus_zero ? text.substr(1) : text;
}

std::string shortestText(double value)
{
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::optional<double> parseNumber(std::string_view text)
{
  const std::optional<double> value = parseWhole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> parseInteger(std::string_view text) { return parseWhole<int>(text); }
}  // namespace mrpt_ext
