#pragma once

#include <string>
#include <vector>

#include "mrpt_ext/evaluation/run_score.h"

namespace mrpt_ext
{
/// What the figures say about methods that track beside the judged one, a sentence each: as accurate, more or less
/// accurate, or not told apart, and at which share of the cost. Two methods are as accurate as each other when the 95 %
/// interval of the ratio of their RMSE stays within 5 % of one.
[[nodiscard]] std::vector<std::string> comparisonSentences(const RunScore& score);

/// The posterior Cramer-Rao bound, and how far above it the methods that track are; or why there is none. Empty where
/// it does not apply at all.
[[nodiscard]] std::string limitText(const RunScore& score);
}  // namespace mrpt_ext
