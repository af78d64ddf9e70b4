#pragma once

#include <vector>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Errors of all methods at common stamps.
struct ErrorSeries
{
  std::vector<double> stamps;                                        ///< [s] since the start of the log
  std::vector<std::vector<OptionalNumber>> position_m, heading_deg;  ///< per method and stamp
  std::size_t stamps_per_entry = 1;  ///< each entry holds the largest error of so many stamps
};

/// How many of `entries` neighbours are merged into one, so that at most `most` are left.
[[nodiscard]] inline std::size_t entriesPerPoint(std::size_t entries, std::size_t most)
{
  return entries == 0 ? 1 : (entries - 1) / most + 1;
}

/// At most about `max_stamps`: neighbouring stamps are merged by their largest error, so that no failure is hidden.
[[nodiscard]] ErrorSeries errorSeries(const RunContext& context, const RunScore& score, std::size_t max_stamps);
}  // namespace mrpt_ext
