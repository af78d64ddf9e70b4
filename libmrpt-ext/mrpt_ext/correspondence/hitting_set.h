#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mrpt_ext/geometry/work_budget.h"

namespace mrpt_ext
{
/// A set with a member in each of some triples.
struct HittingSet
{
  std::vector<int> members;
  std::size_t least = 0;  ///< no hitting set is smaller; equal to members.size() where the set is known to be smallest
};

/// The smallest hitting set of triples of small non-negative numbers, by branch and bound: NP-hard (Karp 1972), 3^size
/// steps at worst. Each triple beyond the present set that is disjoint from the others needs a member of its own
/// (greedy packing), which bounds the size from below. Where `budget` ends the search the set is the greedy one, of the
/// numbers in most triples, and `least` the bound reached until then. `known_least`: a bound known before.
[[nodiscard]] HittingSet smallestHittingSet(std::span<const std::array<int, 3>> triples, std::size_t known_least,
                                            WorkBudget& budget);
}  // namespace mrpt_ext
