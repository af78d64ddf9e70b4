#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace mrpt_ext
{
// Sorting, pruning and removing duplicates, for weighted hypotheses of any type. `log_weight(h)` is the logarithm of a
// weight or likelihood up to a common constant; `same(better, other)` is true for duplicates.

/// Sorts best first; equal hypotheses keep their order.
template <typename Hypothesis, typename LogWeight>
void sortByLogWeight(std::vector<Hypothesis>& hypotheses, LogWeight&& log_weight)
{
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [&](const Hypothesis& a, const Hypothesis& b)
                   { return std::invoke(log_weight, a) > std::invoke(log_weight, b); });
}

/// Drops the hypotheses of a sorted set that are more than `margin` log units worse than the best one.
template <typename Hypothesis, typename LogWeight>
void pruneUnlikely(std::vector<Hypothesis>& sorted, double margin, LogWeight&& log_weight)
{
  const auto unlikely =
      std::find_if(sorted.begin(), sorted.end(),
                   [&](const Hypothesis& h)
                   { return std::invoke(log_weight, h) < std::invoke(log_weight, sorted.front()) - margin; });
  sorted.erase(unlikely, sorted.end());
}

/// Keeps the best of all duplicates of a sorted set, and at most `max_count` hypotheses.
template <typename Hypothesis, typename Same>
void mergeSame(std::vector<Hypothesis>& sorted, Same&& same,
               std::size_t max_count = std::numeric_limits<std::size_t>::max())
{
  std::vector<Hypothesis> kept;
  for (Hypothesis& candidate : sorted)
  {
    if (kept.size() >= max_count) break;
    if (std::none_of(kept.begin(), kept.end(), [&](const Hypothesis& k) { return same(k, candidate); }))
      kept.push_back(std::move(candidate));
  }
  sorted = std::move(kept);
}
}  // namespace mrpt_ext
