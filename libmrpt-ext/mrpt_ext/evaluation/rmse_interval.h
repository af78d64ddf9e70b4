#pragma once

#include <optional>
#include <vector>

#include "mrpt_ext/evaluation/scoring.h"

namespace mrpt_ext
{
/// Interval that contains 95 % of the resamples.
struct ConfidenceInterval
{
  double low = 0, high = 0;
};

/// Interval of the position RMSE over the samples from `from` on [m]: moving blocks of ten neighbouring stamps are
/// resampled, see rmseRatio(). Nothing with fewer than fifty samples.
[[nodiscard]] std::optional<ConfidenceInterval> rmseInterval(const std::vector<ErrorSample>& errors, double from);

/// Interval of the median of independent values (Efron 1979). Nothing with fewer than five.
[[nodiscard]] std::optional<ConfidenceInterval> medianInterval(const std::vector<double>& values);
}  // namespace mrpt_ext
