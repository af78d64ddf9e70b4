#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mrpt_ext
{
/// Number text that is the same on every machine and under every locale; all writers and readers go through here.

/// Fixed notation with `decimals` digits behind the point, never "-0.000"; "nan", "inf", "-inf" when not finite.
[[nodiscard]] std::string fixedText(double value, int decimals);

/// The shortest text that reads back as exactly the same double.
[[nodiscard]] std::string shortestText(double value);

/// The whole text as a finite number (optional sign, decimal or exponent notation); nothing otherwise.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

/// The whole text as an integer (optional sign); nothing otherwise.
[[nodiscard]] std::optional<int> parseInteger(std::string_view text);
}  // namespace mrpt_ext
