#pragma once

#include <algorithm>
#include <vector>

namespace mrpt_ext
{
/// The middle value, of an even number the upper one of the two in the middle. There must be one.
[[nodiscard]] inline double medianOf(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}
}  // namespace mrpt_ext
