#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace mrpt_ext
{
/// Indices, in order, of at most `count` detections that cover all directions as the whole list does: every n-th in the
/// order of bearing (of range, where there is none). What is left out is chosen without regard to what it shows, so the
/// share of false detections stays as it is.
template <typename Detection>
[[nodiscard]] std::vector<std::size_t> evenChoice(std::span<const Detection> detections, std::size_t count)
{
  std::vector<std::size_t> order(detections.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (detections.size() <= count) return order;
  const auto key = [&](std::size_t d) { return detections[d].bearing.value_or(detections[d].range.value_or(0)); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < count; ++k) chosen.push_back(order[k * detections.size() / count]);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}
}  // namespace mrpt_ext
