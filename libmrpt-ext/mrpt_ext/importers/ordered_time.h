#pragma once

#include <cmath>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/files/text_table.h"
#include "mrpt_ext/geometry/physical_limits.h"

namespace mrpt_ext
{
/// Time of a row [s], which must not be before that of the row above.
[[nodiscard]] inline double orderedTime(const TextTable& table, std::size_t row, std::size_t column = 0)
{
  const auto stamp = parseNumber(table.text(row, column));
  if (stamp && std::abs(*stamp) > kLargestTime)
    throw table.errorAt(row, "time " + table.text(row, column) +
                                 " is too large, expected seconds: divide milliseconds by 1000, nanoseconds by 1e9");
  const double time = table.number(row, column);
  if (row > 0 && time < table.number(row - 1, column))
    throw table.errorAt(row, "time " + table.text(row, column) + " is before the row above, expected ascending times");
  return time;
}

/// The same where a time may occur once only, as for the poses of a truth.
[[nodiscard]] inline double ascendingTime(const TextTable& table, std::size_t row, std::size_t column = 0)
{
  const double time = orderedTime(table, row, column);
  if (row > 0 && time == table.number(row - 1, column))
    throw table.errorAt(row, "time " + table.text(row, column) + " occurs twice, expected one row per time");
  return time;
}
}  // namespace mrpt_ext
