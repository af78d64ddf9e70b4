#pragma once

#include <vector>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// Merges the scores of several trials of one run: each number is the median over the trials that have it,
/// shares of verdicts are means, `trials` lists all of them, `success_rate` is their share of successes, and the
/// verdict is the worst one, with a reason that counts the trials concerned. One trial stays as it is; none gives an
/// empty score.
[[nodiscard]] RunScore mergeScores(const std::vector<RunScore>& trials);
}  // namespace mrpt_ext
