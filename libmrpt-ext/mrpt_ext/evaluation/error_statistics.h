#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace mrpt_ext
{
/// Figures of a sample of absolute errors, in the unit of the sample. Without a sample no figure exists:
/// absent, never 0.
struct ErrorStatistics
{
  std::size_t count = 0;
  std::optional<double> rmse, mean, median;
  std::optional<double> std;  ///< about the mean, divisor n, so that rmse^2 = mean^2 + std^2
  std::optional<double> min, max, p95;
};

[[nodiscard]] ErrorStatistics errorStatistics(std::vector<double> sample);

/// Quantile of a sample by linear interpolation between order statistics: with x_0 <= ... <= x_(n-1) the value at
/// position `probability` (n - 1) (definition 7 of Hyndman and Fan 1996, the default of NumPy and R).
[[nodiscard]] std::optional<double> quantile(std::vector<double> sample, double probability);

[[nodiscard]] inline std::optional<double> median(std::vector<double> sample)
{
  return quantile(std::move(sample), 0.5);
}
}  // namespace mrpt_ext
