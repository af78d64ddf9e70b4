#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/settings/key_choice.h"

namespace mrpt_ext
{
// Values of .ini files as types, beside parseNumber() of files/number_format.h; nothing when the whole text is not such
// a value.

[[nodiscard]] std::optional<std::int64_t> parseWholeNumber(const std::string& text);
[[nodiscard]] std::optional<bool> parseFlag(const std::string& text);
[[nodiscard]] std::optional<std::vector<double>> parseNumbers(const std::string& text);  ///< at least one
/// Words separated by blanks or commas.
[[nodiscard]] std::vector<std::string> parseWords(const std::string& text);
/// The choice's name, from its name or its number.
[[nodiscard]] std::optional<std::string> parseChoice(const std::string& text, const std::vector<KeyChoice>& choices);
}  // namespace mrpt_ext
