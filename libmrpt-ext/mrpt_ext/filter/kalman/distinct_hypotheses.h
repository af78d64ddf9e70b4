#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace mrpt_ext
{
/// Keeps the first of all hypotheses that are the `same(kept, other)`; `absorb(kept, other)` takes what the dropped one
/// contributes.
template <typename Hypothesis, typename Same, typename Absorb>
void keepDistinct(std::vector<Hypothesis>& hypotheses, Same same, Absorb absorb)
{
  std::vector<Hypothesis> kept;
  for (Hypothesis& candidate : hypotheses)
  {
    const auto twin = std::find_if(kept.begin(), kept.end(), [&](const Hypothesis& k) { return same(k, candidate); });
    if (twin == kept.end())
      kept.push_back(std::move(candidate));
    else
      absorb(*twin, candidate);
  }
  hypotheses = std::move(kept);
}
}  // namespace mrpt_ext
