#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace mrpt_ext
{
/// Quantile of a sample by linear interpolation between order statistics: with x_0 <= ... <= x_(n-1) the value at
/// position `probability` (n - 1) (definition 7 of Hyndman and Fan 1996, the default of NumPy and R). Nothing without a
/// sample.
[[nodiscard]] std::optional<double> quantile(std::vector<double> sample, double probability);
/// The same of an ascending sample that is not empty.
[[nodiscard]] double quantileOfSorted(const std::vector<double>& sorted, double probability);

/// quantile(sample, 0.5): of an even number of values the mean of the two in the middle.
[[nodiscard]] std::optional<double> median(std::vector<double> sample);

/// The middle value, of an even number the upper one of the two in the middle: always one of the values, found in
/// linear time. There must be one.
template <typename Value = double>
[[nodiscard]] Value upperMedian(std::vector<Value> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median of the absolute values of a standard normal variable: a median absolute deviation divided by it estimates the
/// standard deviation.
constexpr double kNormalMedianDeviation = 0.6745;
}  // namespace mrpt_ext
