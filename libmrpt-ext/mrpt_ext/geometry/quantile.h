#pragma once

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
[[nodiscard]] double upperMedian(std::vector<double> values);
}  // namespace mrpt_ext
