#pragma once

#include <optional>
#include <string_view>

namespace mrpt_ext
{
/// `year-month-day hour:minute:second`, the seconds perhaps with decimals, each number with or without leading zeros,
/// as seconds since 1970 in the same time zone; nothing for any other text and for days that do not exist.
[[nodiscard]] std::optional<double> parseDateTime(std::string_view text);
}  // namespace mrpt_ext
