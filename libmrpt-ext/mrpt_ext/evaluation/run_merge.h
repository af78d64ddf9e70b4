#pragma once

#include <vector>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Merges the scores of several trials of one run: each figure is the median over the trials in which it exists,
/// `trials` lists all of them, `success_rate` is their share of successes, and the verdict is the worst one, with a
/// reason that says how many trials it concerns. One trial stays as it is; none gives an empty score.
[[nodiscard]] RunScore mergeScores(const std::vector<RunScore>& trials);
}  // namespace mrpt_ext
