#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace mrpt_ext
{
/// Statistics of a sample of absolute errors, in the unit of the sample. An empty sample has none: absent, never 0.
struct ErrorStatistics
{
  std::size_t count = 0;
  std::optional<double> rmse, mean, median;
  std::optional<double> std;  ///< about the mean, divisor n, so that rmse^2 = mean^2 + std^2
  std::optional<double> min, max, p95;
};

[[nodiscard]] ErrorStatistics errorStatistics(std::vector<double> sample);
}  // namespace mrpt_ext
