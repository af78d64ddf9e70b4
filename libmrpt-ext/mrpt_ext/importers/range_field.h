#pragma once

#include <optional>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/files/text_table.h"

namespace mrpt_ext
{
/// A range of a radio [m] up to `most`, beyond which it must be in other units; nothing for an empty field and for a
/// zero, which radios write when nothing answered.
[[nodiscard]] inline std::optional<double> radioRange(const TextTable& table, std::size_t row, std::size_t column,
                                                      double most)
{
  const auto range = table.optionalNumber(row, column);
  if (!range || *range == 0) return std::nullopt;
  if (*range < 0 || *range > most)
    throw table.errorAt(row, "range " + table.text(row, column) + ", expected metres within 0 ... " +
                                 shortestText(most) + " (" + table.columns()[column] + ")");
  return range;
}
}  // namespace mrpt_ext
