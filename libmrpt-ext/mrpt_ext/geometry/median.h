#pragma once

#include <algorithm>
#include <vector>

namespace mrpt_ext
{
/// The middle value; of an even count the upper one of the two in the middle. `values` must not be empty.
[[nodiscard]] inline double medianOf(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}
}  // namespace mrpt_ext
