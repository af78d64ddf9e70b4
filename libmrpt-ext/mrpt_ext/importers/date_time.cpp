#include "mrpt_ext/importers/date_time.h"

#include <chrono>

#include "mrpt_ext/files/number_format.h"

namespace mrpt_ext
{
namespace
{
/// Takes the part before `delimiter` off the text; the whole text when it has none.
std::string_view takeUntil(std::string_view& text, char delimiter)
{
  const std::size_t end = text.find(delimiter);
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return part;
}
}  // namespace

std::optional<double> parseDateTime(std::string_view text)
{
  const auto year = parseInteger(takeUntil(text, '-')), month = parseInteger(takeUntil(text, '-')),
             day = parseInteger(takeUntil(text, ' ')), hour = parseInteger(takeUntil(text, ':')),
             minute = parseInteger(takeUntil(text, ':'));
  const auto second = parseNumber(text);
  if (!year || !month || !day || !hour || !minute || !second) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  const bool in_range = *hour >= 0 && *hour < 24 && *minute >= 0 && *minute < 60 && *second >= 0 && *second < 61;
  if (!date.ok() || !in_range) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return static_cast<double>(((static_cast<long long>(days) * 24 + *hour) * 60 + *minute) * 60) + *second;
}
}  // namespace mrpt_ext
