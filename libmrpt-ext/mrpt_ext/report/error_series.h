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
  std::size_t seconds_joined = 1;  ///< stamps that one entry stands for, by the worst of them
};

/// At most about `max_stamps`: neighbours are joined by their largest error, so that no failure is hidden.
[[nodiscard]] ErrorSeries errorSeries(const RunContext& context, const RunScore& score, std::size_t max_stamps);
}  // namespace mrpt_ext
